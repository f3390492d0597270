#pragma once

#include <tendon/base/clock.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace tendon {

class SerialExecutor;

/// A thread pool for calls from other processes that run code of a component in the calling thread.
/// Such code may take long, so it must not run in a thread of the middleware. The pool has at most
/// kMax threads. They are started when needed and end when they were idle for 10 s. Thread-safe.
class WorkerPool {
 public:
  static constexpr std::size_t kMax = 4;

  explicit WorkerPool(std::string name);
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  /// Drops queued calls and waits until running calls have ended. Must not be called by a call of
  /// this pool.
  ~WorkerPool();

  /// Makes a serial executor. Its queue holds at most `most_calls` calls, and at most `most_bytes`
  /// of memory that the calls own; a single call may own more. The executor may outlive this
  /// object.
  [[nodiscard]] std::shared_ptr<SerialExecutor> MakeExecutor(
      std::size_t most_calls, std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

 private:
  friend class SerialExecutor;
  class Pool;

  const std::shared_ptr<Pool> pool_;
};

/// A queue of calls that a WorkerPool executes one at a time, in order. The queues of different
/// executors are executed in parallel. Thread-safe.
class SerialExecutor {
 public:
  using Call = std::function<void()>;

  SerialExecutor(const SerialExecutor&) = delete;
  SerialExecutor& operator=(const SerialExecutor&) = delete;
  ~SerialExecutor();

  /// Adds a call to the queue; `bytes` is the memory that the call owns. Exceptions of the call are
  /// logged. Returns false and changes nothing if the queue is full or the pool has ended.
  bool Post(Call call, std::size_t bytes = 0);
  /// Waits until no call is queued or running. Returns false if `deadline` passes first.
  bool Drain(SteadyTime deadline);

 private:
  friend class WorkerPool;
  struct Queue;

  SerialExecutor(std::shared_ptr<WorkerPool::Pool> pool, std::size_t most_calls,
                 std::size_t most_bytes);

  const std::shared_ptr<WorkerPool::Pool> pool_;
  const std::shared_ptr<Queue> queue_;
};

/// The thread pools of one process. There is one for each kind of call, so that calls that hang
/// delay only calls of the same kind.
struct CallExecutors {
  WorkerPool reads{"reads"};
  WorkerPool commands{"commands"};
  WorkerPool events{"events"};
};

}  // namespace tendon
