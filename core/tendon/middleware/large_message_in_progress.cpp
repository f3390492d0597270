#include <tendon/middleware/large_message_in_progress.h>

#include <tendon/lockfree/flag.h>

#include <algorithm>
#include <mutex>
#include <vector>

namespace tendon {
namespace {

/// The time at which one thread began to handle a large message; read by all threads.
using Since = Published<SteadyTime>;

constexpr SteadyTime kNothing{};

/// The threads that handle large messages. There is one object for the whole process, because a
/// thread of a middleware may serve many links.
struct BusyThreads {
  std::mutex mutex;
  std::vector<const Since*> all;
  SteadyTime last{};
};

BusyThreads& AllBusyThreads() {
  static BusyThreads& threads = *new BusyThreads;  // never destroyed: threads may use it
  return threads;
}

class BusyThread {
 public:
  BusyThread() {
    const std::scoped_lock lock(AllBusyThreads().mutex);
    AllBusyThreads().all.push_back(&since);
  }
  BusyThread(const BusyThread&) = delete;
  BusyThread& operator=(const BusyThread&) = delete;
  ~BusyThread() {
    const std::scoped_lock lock(AllBusyThreads().mutex);
    std::erase(AllBusyThreads().all, &since);
  }

  Since since{kNothing};
};

Since& SinceOfThisThread() {
  thread_local BusyThread thread;
  return thread.since;
}

/// Returns the time until which work that began at `since` excuses the silence of peers. Returns
/// kNothing if the work has not taken long enough.
SteadyTime ExcusedBy(SteadyTime since, SteadyTime now) {
  const bool excuses = since != kNothing && now - since >= LargeMessageInProgress::kShort;
  return excuses ? std::min(now, since + LargeMessageInProgress::kAtMost) : kNothing;
}

void Keep(SteadyTime excused) {
  if (excused == kNothing) return;
  const std::scoped_lock lock(AllBusyThreads().mutex);
  AllBusyThreads().last = std::max(AllBusyThreads().last, excused);
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
  const std::scoped_lock lock(AllBusyThreads().mutex);
  SteadyTime last = AllBusyThreads().last;
  for (const Since* since : AllBusyThreads().all) {
    last = std::max(last, ExcusedBy(since->Get(), now));
  }
  return last;
}

}  // namespace tendon
