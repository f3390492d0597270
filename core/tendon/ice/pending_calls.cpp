#include <tendon/ice/pending_calls.h>

#include <tendon/middleware/pending_requests.h>

#include <exception>
#include <iterator>
#include <new>
#include <stdexcept>
#include <utility>

namespace tendon::ice {

void PendingCalls::Add(const Call& call) noexcept {
  try {
    const std::scoped_lock lock(mutex_);
    if (!is_released_) {
      calls_.emplace(call, SteadyClock().Now());
      return;
    }
  } catch (const std::bad_alloc&) {
    // There is not enough memory to keep the call.
  }
  SendEmptyReply(*call);
}

bool PendingCalls::Take(const Call& call) {
  const std::scoped_lock lock(mutex_);
  return calls_.erase(call) > 0;
}

void PendingCalls::ReleaseOld(SteadyTime now) noexcept {
  std::map<Call, SteadyTime> old;
  {
    const std::scoped_lock lock(mutex_);
    for (auto one = calls_.begin(); one != calls_.end();) {
      const auto next = std::next(one);
      if (now - one->second > kOpenAtMost) old.insert(calls_.extract(one));
      one = next;
    }
  }
  for (const auto& [call, since] : old) SendEmptyReply(*call);
}

void PendingCalls::Release() noexcept {
  std::map<Call, SteadyTime> released;
  {
    const std::scoped_lock lock(mutex_);
    is_released_ = true;
    released = std::exchange(calls_, {});
  }
  for (const auto& [call, since] : released) SendEmptyReply(*call);
}

void SendEmptyReply(IceInternal::IncomingAsync& call) noexcept {
  CallGuarded("ice", [&call] {
    call.startWriteParams()->writeSize(0);
    call.endWriteParams();
    call.completed();
  });
}

void SendFailure(IceInternal::IncomingAsync& call) noexcept {
  CallGuarded("ice", [&call] {
    call.completed(std::make_exception_ptr(std::runtime_error("the reply could not be written")));
  });
}

}  // namespace tendon::ice
