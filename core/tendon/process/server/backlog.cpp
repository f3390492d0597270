#include <tendon/process/server/backlog.h>

namespace tendon {

std::shared_ptr<Backlog::Place> Backlog::Enter(std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  if (tasks_ == kMostTasks || bytes > kMostBytes - bytes_) return nullptr;
  auto place = std::make_shared<Place>(shared_from_this(), bytes);
  ++tasks_;
  bytes_ += bytes;
  return place;
}

void Backlog::Leave(std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  --tasks_;
  bytes_ -= bytes;
}

}  // namespace tendon
