#include <tendon/middleware/parts/large_in_hand.h>

#include <algorithm>
#include <mutex>

namespace tendon {

/// Of this process: threads of a middleware may serve many links.
struct LargeInHand::Hand {
  std::mutex mutex;
  LargeInHand* oldest = nullptr;
  LargeInHand* newest = nullptr;
  SteadyTime last{};
};

LargeInHand::Hand& LargeInHand::TheHand() {
  static Hand hand;
  return hand;
}

LargeInHand::LargeInHand() {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  since_ = SteadyClock().Now();
  older_ = hand.newest;
  (older_ != nullptr ? older_->newer_ : hand.oldest) = this;
  hand.newest = this;
}

LargeInHand::~LargeInHand() {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  const SteadyTime now = SteadyClock().Now();
  if (now - since_ >= kShort) hand.last = std::max(hand.last, std::min(now, since_ + kAtMost));
  (older_ != nullptr ? older_->newer_ : hand.oldest) = newer_;
  (newer_ != nullptr ? newer_->older_ : hand.newest) = older_;
}

SteadyTime LargeInHand::Last(SteadyTime now) {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  SteadyTime last = hand.last;
  for (const LargeInHand* one = hand.oldest; one != nullptr; one = one->newer_) {
    if (now - one->since_ < kShort) break;  // and so are the newer ones
    last = std::max(last, std::min(now, one->since_ + kAtMost));
  }
  return last;
}

}  // namespace tendon
