#include <tendon/middleware/parts/large_in_hand.h>

#include <mutex>

namespace tendon {
namespace {

/// Of this process: threads of a middleware may serve many links.
struct Hand {
  std::mutex mutex;
  int held = 0;
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
  ++hand.held;
}

LargeInHand::~LargeInHand() {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  --hand.held;
  hand.last = SteadyClock().Now();
}

SteadyTime LargeInHand::Last(SteadyTime now) {
  Hand& hand = TheHand();
  const std::scoped_lock lock(hand.mutex);
  return hand.held > 0 ? now : hand.last;
}

}  // namespace tendon
