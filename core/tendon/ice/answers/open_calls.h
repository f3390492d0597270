#pragma once

#include <Ice/Ice.h>
#include <Ice/IncomingAsync.h>

#include <memory>
#include <mutex>
#include <set>

namespace tendon::ice {

/// Calls of one peer that Ice has dispatched and that are not answered yet. It closes no connection
/// gracefully, and ends no adapter, while there are any. Thread-safe.
class OpenCalls {
 public:
  using Call = std::shared_ptr<IceInternal::IncomingAsync>;

  /// Where they are released, or there is no memory to keep it, the call is answered with nothing.
  void Add(const Call& call) noexcept;
  /// Whether who calls this is to answer it now; nobody else does then.
  [[nodiscard]] bool Take(const Call& call);
  /// Answers all with nothing, now and for all time.
  void Release() noexcept;

 private:
  std::mutex mutex_;
  bool is_released_ = false;
  std::set<Call> calls_;
};

/// What `call` is answered with where the frame comes otherwise, or not at all.
void AnswerWithNothing(IceInternal::IncomingAsync& call) noexcept;
/// Where the frame was begun and is not whole.
void AnswerWithFailure(IceInternal::IncomingAsync& call) noexcept;

}  // namespace tendon::ice
