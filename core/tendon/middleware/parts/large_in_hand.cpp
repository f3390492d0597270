#include <tendon/middleware/parts/large_in_hand.h>

#include <algorithm>
#include <mutex>

namespace tendon {
namespace {

/// Of this process: threads of a middleware may serve many links.
struct Hand {
  std::mutex mutex;
  int held = 0;
  SteadyTime since{};  ///< while it is held
  SteadyTime last{};
};

Hand& TheHand() {
  static Hand hand;
  return hand;
}

}  // namespace

LargeInHand::LargeInHand() {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  if (hand.held++ == 0) hand.since = SteadyClock().Now();
}

LargeInHand::~LargeInHand() {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  if (--hand.held == 0) hand.last = std::min(SteadyClock().Now(), hand.since + kAtMost);
}

SteadyTime LargeInHand::Last(SteadyTime now) {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  return hand.held > 0 ? std::min(now, hand.since + kAtMost) : hand.last;
}

}  // namespace tendon
