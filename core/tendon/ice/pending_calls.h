#pragma once

#include <Ice/Ice.h>
#include <Ice/IncomingAsync.h>
#include <tendon/base/clock.h>

#include <chrono>
#include <map>
#include <memory>
#include <mutex>

namespace tendon::ice {

/// The calls of one peer that Ice has dispatched and that have no reply yet. While there are any,
/// Ice does not close an idle connection, close gracefully, or end an adapter. Thread-safe.
class PendingCalls {
 public:
  using Call = std::shared_ptr<IceInternal::IncomingAsync>;
  /// A call that takes longer gets its reply in a separate message.
  static constexpr std::chrono::milliseconds kOpenAtMost{500};

  /// Adds a call. Gives it an empty reply if Release() was called or memory is exhausted.
  void Add(const Call& call) noexcept;
  /// Returns true if the caller now owns the reply; at most one caller gets true.
  [[nodiscard]] bool Take(const Call& call);
  /// Gives calls older than kOpenAtMost an empty reply; called regularly.
  void ReleaseOld(SteadyTime now) noexcept;
  /// Gives all calls, also later ones, an empty reply.
  void Release() noexcept;

 private:
  std::mutex mutex_;
  bool is_released_ = false;
  std::map<Call, SteadyTime> calls_;  // open calls, and the time when they began
};

/// Gives an empty reply to a call whose frame is sent separately, or not at all.
void AnswerWithNothing(IceInternal::IncomingAsync& call) noexcept;
/// Gives a failure as the reply to a call whose frame was begun and not completed.
void AnswerWithFailure(IceInternal::IncomingAsync& call) noexcept;

}  // namespace tendon::ice
