#pragma once

#include <tendon/base/clock.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace tendon {

class CallLine;

/// A thread pool for calls from other processes that run component code in their caller's thread.
/// Such code may take long, and threads of the middleware must not wait for it. At most kMost
/// threads; they start on demand and end after a long idle time. Thread-safe.
class CallThreads {
 public:
  static constexpr std::size_t kMost = 4;

  explicit CallThreads(std::string name);
  CallThreads(const CallThreads&) = delete;
  CallThreads& operator=(const CallThreads&) = delete;
  /// Waits for running calls; drops queued ones. Must not be called from a call.
  ~CallThreads();

  /// A line holds at most `most_calls`, and `most_bytes` in total unless it is a single call. It
  /// may outlive this object.
  [[nodiscard]] std::shared_ptr<CallLine> MakeLine(
      std::size_t most_calls, std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

 private:
  friend class CallLine;
  class Pool;

  const std::shared_ptr<Pool> pool_;
};

/// Executes its calls one at a time, in order. Different lines run in parallel. Thread-safe.
class CallLine {
 public:
  using Call = std::function<void()>;

  CallLine(const CallLine&) = delete;
  CallLine& operator=(const CallLine&) = delete;
  ~CallLine();

  /// Logs what `call` throws. Returns false without an effect if too much waits or the pool has
  /// ended. `bytes` is the memory that the call owns.
  bool Post(Call call, std::size_t bytes = 0);
  /// Waits until no call runs or waits; returns false if one still does at `deadline`.
  bool Drain(SteadyTime deadline);

 private:
  friend class CallThreads;
  struct Queue;

  CallLine(std::shared_ptr<CallThreads::Pool> pool, std::size_t most_calls, std::size_t most_bytes);

  const std::shared_ptr<CallThreads::Pool> pool_;
  const std::shared_ptr<Queue> queue_;
};

/// The thread pools of one process, one for each kind of call, so that calls that hang delay only
/// their own kind.
struct SortsOfCalls {
  CallThreads reads{"reads"};
  CallThreads commands{"commands"};
  CallThreads events{"events"};
};

}  // namespace tendon
