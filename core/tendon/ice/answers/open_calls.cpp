#include <tendon/ice/answers/open_calls.h>

#include <utility>

namespace tendon::ice {

void OpenCalls::Add(const Call& call) {
  {
    const std::scoped_lock lock(mutex_);
    if (!is_released_) {
      calls_.insert(call);
      return;
    }
  }
  AnswerWithNothing(*call);
}

bool OpenCalls::Take(const Call& call) {
  const std::scoped_lock lock(mutex_);
  return calls_.erase(call) > 0;
}

void OpenCalls::Release() {
  std::set<Call> released;
  {
    const std::scoped_lock lock(mutex_);
    is_released_ = true;
    released = std::exchange(calls_, {});
  }
  for (const Call& call : released) AnswerWithNothing(*call);
}

void AnswerWithNothing(IceInternal::IncomingAsync& call) {
  call.startWriteParams()->writeSize(0);
  call.endWriteParams();
  call.completed();
}

}  // namespace tendon::ice
