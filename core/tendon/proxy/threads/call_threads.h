#pragma once

#include <tendon/base/clock.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace tendon {

class CallLine;

/// Threads that execute what another process has called and what runs in its caller's thread: code
/// of components, which may take its time, and no thread of the middleware waits for it. At most
/// kMost, which are started when they are needed and end when they were idle for long. Thread-safe.
class CallThreads {
 public:
  static constexpr std::size_t kMost = 4;

  explicit CallThreads(std::string name);
  CallThreads(const CallThreads&) = delete;
  CallThreads& operator=(const CallThreads&) = delete;
  /// Waits for the calls that run; those that wait are not executed. Not from a call.
  ~CallThreads();

  /// Of calls of which at most so many wait, with bytes together unless it is one alone. It may
  /// outlive this.
  [[nodiscard]] std::shared_ptr<CallLine> MakeLine(
      std::size_t most_calls, std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

 private:
  friend class CallLine;
  class Pool;

  const std::shared_ptr<Pool> pool_;
};

/// Calls of which one runs at a time, in their order; those of several lines run side by side.
/// Thread-safe.
class CallLine {
 public:
  using Call = std::function<void()>;

  CallLine(const CallLine&) = delete;
  CallLine& operator=(const CallLine&) = delete;
  ~CallLine();

  /// What it throws is logged. False, and it is left alone, where too much waits or nobody executes
  /// calls any more. `bytes` is what it takes beside itself.
  bool Post(Call call, std::size_t bytes = 0);
  /// Waits until none runs and none waits; false where one still does at `deadline`.
  bool Drain(SteadyTime deadline);

 private:
  friend class CallThreads;
  struct Queue;

  CallLine(std::shared_ptr<CallThreads::Pool> pool, std::size_t most_calls, std::size_t most_bytes);

  const std::shared_ptr<CallThreads::Pool> pool_;
  const std::shared_ptr<Queue> queue_;
};

/// The threads of one process, apart for each sort of call: those of one sort that hang hold up no
/// other.
struct SortsOfCalls {
  CallThreads reads{"reads"};
  CallThreads commands{"commands"};
  CallThreads events{"events"};
};

}  // namespace tendon
