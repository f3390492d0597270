#pragma once

#include <tendon/base/result.h>

#include <cstdint>
#include <functional>
#include <thread>

namespace tendon {

/// While this object exists, no thread of this program opens links: attempts in progress are
/// cancelled at once, and new attempts fail. Used when a program ends, because its threads may wait
/// for a link to a process that hangs. Thread-safe.
class ConnectCancellation {
 public:
  ConnectCancellation() : ConnectCancellation(std::thread::id()) {}
  /// Cancels the attempts of one thread only. Other threads are not affected.
  explicit ConnectCancellation(std::thread::id thread);
  ConnectCancellation(const ConnectCancellation&) = delete;
  ConnectCancellation& operator=(const ConnectCancellation&) = delete;
  ~ConnectCancellation();

 private:
  const std::thread::id thread_;  // a default-constructed id means all threads
};

/// Registers that this thread waits for a link, so that a ConnectCancellation can end the wait.
class CancellableConnect {
 public:
  /// A ConnectCancellation calls `give_up`, which must end the wait and must not block. `give_up`
  /// may be called several times, in any thread, and even before this constructor returns. It is
  /// never called after the destructor.
  explicit CancellableConnect(std::function<void()> give_up);
  CancellableConnect(const CancellableConnect&) = delete;
  CancellableConnect& operator=(const CancellableConnect&) = delete;
  ~CancellableConnect();

 private:
  std::uint64_t number_ = 0;
};

/// True if a ConnectCancellation applies to this thread.
[[nodiscard]] bool AreConnectsCancelled();
/// The error for a cancelled attempt. Its code is kUnreachable.
[[nodiscard]] Error ConnectCancelledError();

}  // namespace tendon
