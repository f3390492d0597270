#include <tendon/ice/links.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tendon::ice {

void Links::Add(const std::shared_ptr<Links>& links, const std::shared_ptr<IceLink>& link) {
  bool is_shut = false;
  {
    const std::scoped_lock lock(links->mutex_);
    links->links_.emplace(link->connection_.get(), link);
    is_shut = links->is_shut_;
  }
  link->connection_->setCloseCallback([links, link](const std::shared_ptr<Ice::Connection>&) {
    link->OnGone();
    const std::scoped_lock lock(links->mutex_);
    links->links_.erase(link->connection_.get());
    links->changed_.notify_all();
  });
  if (is_shut) link->CloseAtOnce();
}

void Links::ReleaseOldCalls(SteadyTime now) {
  std::vector<std::shared_ptr<IceLink>> all;
  {
    const std::scoped_lock lock(mutex_);
    for (const auto& [connection, link] : links_) all.push_back(link);
  }
  for (const auto& link : all) link->pending_calls().ReleaseOld(now);
}

std::shared_ptr<IceLink> Links::Find(const std::shared_ptr<Ice::Connection>& connection) {
  const std::scoped_lock lock(mutex_);
  const auto found = links_.find(connection.get());
  return found == links_.end() ? nullptr : found->second;
}

std::shared_ptr<IceLink> Links::Find(const SocketAddresses& addresses) {
  const std::scoped_lock lock(mutex_);
  const auto found = std::ranges::find_if(links_, [&](const auto& one) {
    return one.second->local() == addresses.local && one.second->peer() == addresses.peer;
  });
  return found == links_.end() ? nullptr : found->second;
}

void Links::CloseAll(std::uint64_t listener) {
  const auto is_meant = [listener](const auto& one) {
    return listener == 0 || one.second->listener_ == listener;
  };
  std::vector<std::shared_ptr<IceLink>> meant;
  std::unique_lock lock(mutex_);
  if (listener == 0) is_shut_ = true;
  for (const auto& one : links_) {
    if (is_meant(one)) meant.push_back(one.second);
  }
  lock.unlock();
  for (const auto& link : meant) link->CloseAtOnce();
  lock.lock();
  changed_.wait(lock, [&] { return std::none_of(links_.begin(), links_.end(), is_meant); });
}

}  // namespace tendon::ice
