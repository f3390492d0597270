#include <tendon/ice/answers/open_calls.h>
#include <tendon/middleware/requests/pending_requests.h>

#include <exception>
#include <new>
#include <stdexcept>
#include <utility>

namespace tendon::ice {

void OpenCalls::Add(const Call& call) noexcept {
  try {
    const std::scoped_lock lock(mutex_);
    if (!is_released_) {
      calls_.insert(call);
      return;
    }
  } catch (const std::bad_alloc&) {
    // It cannot be kept.
  }
  AnswerWithNothing(*call);
}

bool OpenCalls::Take(const Call& call) {
  const std::scoped_lock lock(mutex_);
  return calls_.erase(call) > 0;
}

void OpenCalls::Release() noexcept {
  std::set<Call> released;
  {
    const std::scoped_lock lock(mutex_);
    is_released_ = true;
    released = std::exchange(calls_, {});
  }
  for (const Call& call : released) AnswerWithNothing(*call);
}

void AnswerWithNothing(IceInternal::IncomingAsync& call) noexcept {
  CallGuarded("ice", [&call] {
    call.startWriteParams()->writeSize(0);
    call.endWriteParams();
    call.completed();
  });
}

void AnswerWithFailure(IceInternal::IncomingAsync& call) noexcept {
  CallGuarded("ice", [&call] {
    call.completed(std::make_exception_ptr(std::runtime_error("the answer could not be written")));
  });
}

}  // namespace tendon::ice
