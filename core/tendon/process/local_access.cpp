#include <tendon/process/local_access.h>

#include <tendon/middleware/loopback.h>

namespace tendon {

LocalAccess::LocalAccess(std::string process, std::uint64_t instance, Describe describe)
    : process_(std::move(process)),
      instance_(instance),
      network_(std::make_shared<LoopbackNetwork>()),
      describe_(std::move(describe)) {}

std::shared_ptr<Middleware> LocalAccess::MakeMiddleware() const {
  return std::make_shared<LoopbackMiddleware>(network_);
}

bool LocalAccess::TryDescribe(ProcessContent& content) const {
  const std::scoped_lock lock(mutex_);
  return describe_ && describe_(content);
}

Result<void> LocalAccess::Listen(AcceptLink accept) {
  auto middleware = MakeMiddleware();
  auto listener = middleware->Listen(kAddress, std::move(accept));
  if (!listener) return listener.error();
  const std::scoped_lock lock(mutex_);
  middleware_ = std::move(middleware);
  listener_ = *std::move(listener);
  return {};
}

void LocalAccess::Close() {
  std::unique_ptr<Listener> listener;
  std::shared_ptr<Middleware> middleware;
  {
    const std::scoped_lock lock(mutex_);
    describe_ = nullptr;
    listener.swap(listener_);
    middleware.swap(middleware_);
  }
  listener.reset();  // before its middleware
}

}  // namespace tendon
