#pragma once

#include <Ice/Ice.h>
#include <Ice/IncomingAsync.h>
#include <tendon/base/clock.h>

#include <chrono>
#include <map>
#include <memory>
#include <mutex>

namespace tendon::ice {

/// Calls of one peer that Ice has dispatched and that are not answered yet. While there are any it
/// closes no connection that is idle, or gracefully, and ends no adapter. Thread-safe.
class OpenCalls {
 public:
  using Call = std::shared_ptr<IceInternal::IncomingAsync>;
  /// What takes longer is answered by a message of its own.
  static constexpr std::chrono::milliseconds kOpenAtMost{500};

  /// Where they are released, or there is no memory to keep it, the call is answered with nothing.
  void Add(const Call& call) noexcept;
  /// Whether who calls this is to answer it now; nobody else does then.
  [[nodiscard]] bool Take(const Call& call);
  /// Answers those with nothing that are older than they may be; called now and then.
  void ReleaseOld(SteadyTime now) noexcept;
  /// Answers all with nothing, now and for all time.
  void Release() noexcept;

 private:
  std::mutex mutex_;
  bool is_released_ = false;
  std::map<Call, SteadyTime> calls_;  // since when
};

/// What `call` is answered with where the frame comes otherwise, or not at all.
void AnswerWithNothing(IceInternal::IncomingAsync& call) noexcept;
/// Where the frame was begun and is not whole.
void AnswerWithFailure(IceInternal::IncomingAsync& call) noexcept;

}  // namespace tendon::ice
