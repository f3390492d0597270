#pragma once

#include <tendon/base/result.h>

#include <cstdint>
#include <functional>
#include <thread>

namespace tendon {

/// While this object exists, no thread of this program opens links: attempts in progress end at
/// once, and new ones are refused. For a program that ends while threads may be connecting to a
/// process that hangs. Thread-safe.
class ConnectCancellation {
 public:
  ConnectCancellation() : ConnectCancellation(std::thread::id()) {}
  /// The same for one thread only; the rest of the program continues.
  explicit ConnectCancellation(std::thread::id thread);
  ConnectCancellation(const ConnectCancellation&) = delete;
  ConnectCancellation& operator=(const ConnectCancellation&) = delete;
  ~ConnectCancellation();

 private:
  const std::thread::id thread_;  // default-constructed: all threads
};

/// While this object exists, this thread counts as waiting for a link.
class CancellableConnect {
 public:
  /// A ConnectCancellation calls `give_up`, which must end the wait and must not block. It is
  /// called once or more, from any thread, perhaps before this constructor returns, never after the
  /// destructor.
  explicit CancellableConnect(std::function<void()> give_up);
  CancellableConnect(const CancellableConnect&) = delete;
  CancellableConnect& operator=(const CancellableConnect&) = delete;
  ~CancellableConnect();

 private:
  std::uint64_t number_ = 0;
};

/// True if a ConnectCancellation applies to this thread.
[[nodiscard]] bool AreConnectsCancelled();
/// The error for a cancelled attempt, of code kUnreachable.
[[nodiscard]] Error ConnectCancelledError();

}  // namespace tendon
