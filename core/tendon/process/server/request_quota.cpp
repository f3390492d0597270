#include <tendon/process/server/request_quota.h>

namespace tendon {

std::shared_ptr<RequestQuota::Place> RequestQuota::Enter(std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  if (tasks_ == kMostTasks || bytes > kMostBytes - bytes_) return nullptr;
  auto place = std::make_shared<Place>(shared_from_this(), bytes);
  ++tasks_;
  bytes_ += bytes;
  return place;
}

void RequestQuota::Leave(std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  --tasks_;
  bytes_ -= bytes;
}

}  // namespace tendon
