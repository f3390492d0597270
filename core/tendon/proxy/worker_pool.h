#pragma once

#include <tendon/base/clock.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>

namespace tendon {

class SerialExecutor;

/// A thread pool for calls from other processes that run component code in their caller's thread.
/// Such code may take long, and threads of the middleware must not wait for it. At most kMost
/// threads; threads start on demand and end after a long idle time. Thread-safe.
class WorkerPool {
 public:
  static constexpr std::size_t kMost = 4;

  explicit WorkerPool(std::string name);
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;
  /// Waits for running calls; drops queued ones. Must not run inside a call of this pool.
  ~WorkerPool();

  /// Makes a line, which holds at most `most_calls`, and at most `most_bytes` in total; a single
  /// call may exceed the bytes. The line may outlive this object.
  [[nodiscard]] std::shared_ptr<SerialExecutor> MakeLine(
      std::size_t most_calls, std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

 private:
  friend class SerialExecutor;
  class Pool;

  const std::shared_ptr<Pool> pool_;
};

/// A line of calls, which a WorkerPool executes one at a time, in order. Different lines run in
/// parallel. Thread-safe.
class SerialExecutor {
 public:
  using Call = std::function<void()>;

  SerialExecutor(const SerialExecutor&) = delete;
  SerialExecutor& operator=(const SerialExecutor&) = delete;
  ~SerialExecutor();

  /// Adds a call; its exceptions are logged. Returns false without an effect if the line is full or
  /// the pool has ended. `bytes` is the memory that the call owns.
  bool Post(Call call, std::size_t bytes = 0);
  /// Waits until no call runs or waits; returns false if `deadline` passes first.
  bool Drain(SteadyTime deadline);

 private:
  friend class WorkerPool;
  struct Queue;

  SerialExecutor(std::shared_ptr<WorkerPool::Pool> pool, std::size_t most_calls,
                 std::size_t most_bytes);

  const std::shared_ptr<WorkerPool::Pool> pool_;
  const std::shared_ptr<Queue> queue_;
};

/// The thread pools of one process, one for each kind of call, so that hanging calls delay only
/// calls of the same kind.
struct CallExecutors {
  WorkerPool reads{"reads"};
  WorkerPool commands{"commands"};
  WorkerPool events{"events"};
};

}  // namespace tendon
