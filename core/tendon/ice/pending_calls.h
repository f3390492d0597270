#pragma once

#include <Ice/Ice.h>
#include <Ice/IncomingAsync.h>
#include <tendon/base/clock.h>

#include <chrono>
#include <map>
#include <memory>
#include <mutex>

namespace tendon::ice {

/// The calls of one peer that Ice has dispatched and that have no reply yet. Such a call prevents
/// Ice from closing an idle connection, from completing a graceful close, and from ending the
/// adapter. Thread-safe.
class PendingCalls {
 public:
  using Call = std::shared_ptr<IceInternal::IncomingAsync>;
  /// A call that takes longer gets an empty reply of Ice. Then the reply frame is sent later in a
  /// separate message.
  static constexpr std::chrono::milliseconds kOpenAtMost{500};

  /// Adds a call. After Release(), or if memory is exhausted, sends an empty reply instead.
  void Add(const Call& call) noexcept;
  /// Returns true if the caller now owns the reply; at most one caller gets true.
  [[nodiscard]] bool Take(const Call& call);
  /// Sends empty replies to calls that are older than kOpenAtMost. Called regularly.
  void ReleaseOld(SteadyTime now) noexcept;
  /// Sends empty replies to all calls, including calls that are added later.
  void Release() noexcept;

 private:
  std::mutex mutex_;
  bool is_released_ = false;
  std::map<Call, SteadyTime> calls_;  // open calls, with the times when they were added
};

/// Sends an empty reply. The reply frame is sent in a separate message or not at all.
void SendEmptyReply(IceInternal::IncomingAsync& call) noexcept;
/// Sends a failure, because the reply frame was begun but not completed.
void SendFailure(IceInternal::IncomingAsync& call) noexcept;

}  // namespace tendon::ice
