#include <tendon/gcm/members/deferred_actions.h>

#include <utility>

namespace tendon::server {

void DeferredActions::Add(Action action) {
  const std::scoped_lock lock(mutex_);
  actions_.push_back(std::move(action));
}

void DeferredActions::Flush() {
  std::unique_lock lock(mutex_);
  if (flushing_) return;
  flushing_ = true;
  while (!actions_.empty()) {
    Action action = std::move(actions_.front());
    actions_.pop_front();
    lock.unlock();
    action();
    action = nullptr;
    lock.lock();
  }
  flushing_ = false;
}

}  // namespace tendon::server
