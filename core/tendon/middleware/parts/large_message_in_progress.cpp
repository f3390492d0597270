#include <tendon/lockfree/flag.h>
#include <tendon/middleware/parts/large_message_in_progress.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace tendon {
namespace {

/// The time since when one thread handles a large message; read by all threads.
using Since = Published<SteadyTime>;

constexpr SteadyTime kNothing{};

/// One object per process, because a thread of a middleware may serve many links.
struct Hands {
  std::mutex mutex;
  std::vector<const Since*> all;
  SteadyTime last{};
};

Hands& TheHands() {
  static Hands& hands = *new Hands;  // never destroyed: threads may outlive statics
  return hands;
}

class Hand {
 public:
  Hand() {
    const std::scoped_lock lock(TheHands().mutex);
    TheHands().all.push_back(&since);
  }
  Hand(const Hand&) = delete;
  Hand& operator=(const Hand&) = delete;
  ~Hand() {
    const std::scoped_lock lock(TheHands().mutex);
    std::erase(TheHands().all, &since);
  }

  Since since{kNothing};
};

Since& SinceOfThisThread() {
  thread_local Hand hand;
  return hand.since;
}

/// The end of the time in which this work excuses silence; kNothing if the work is too short.
SteadyTime ExcusedBy(SteadyTime since, SteadyTime now) {
  const bool excuses = since != kNothing && now - since >= LargeMessageInProgress::kShort;
  return excuses ? std::min(now, since + LargeMessageInProgress::kAtMost) : kNothing;
}

void Keep(SteadyTime excused) {
  if (excused == kNothing) return;
  const std::scoped_lock lock(TheHands().mutex);
  TheHands().last = std::max(TheHands().last, excused);
}

}  // namespace

LargeMessageInProgress::LargeMessageInProgress()
    : since_(SteadyClock().Now()), outer_since_(SinceOfThisThread().Get()) {
  Keep(ExcusedBy(outer_since_, since_));
  SinceOfThisThread().Set(since_);
}

LargeMessageInProgress::~LargeMessageInProgress() {
  Keep(ExcusedBy(since_, SteadyClock().Now()));
  SinceOfThisThread().Set(outer_since_);
}

SteadyTime LargeMessageInProgress::Last(SteadyTime now) {
  const std::scoped_lock lock(TheHands().mutex);
  SteadyTime last = TheHands().last;
  for (const Since* since : TheHands().all) last = std::max(last, ExcusedBy(since->Get(), now));
  return last;
}

}  // namespace tendon
