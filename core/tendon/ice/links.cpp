#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/links.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tendon::ice {
namespace {

std::string PeerOf(const Ice::Connection& connection) {
  try {
    auto info = connection.getInfo();
    while (info->underlying) info = info->underlying;
    if (const auto address = std::dynamic_pointer_cast<Ice::IPConnectionInfo>(info)) {
      constexpr std::string_view kMapped = "::ffff:";  // IPv4 on a socket of IPv6
      std::string host = address->remoteAddress;
      if (host.starts_with(kMapped)) host.erase(0, kMapped.size());
      return ToString(HostPort{host, static_cast<std::uint16_t>(address->remotePort)});
    }
  } catch (const Ice::Exception&) {
    // It is closed already.
  }
  return "unknown";
}

}  // namespace

Ice::Identity EndpointIdentity() { return {"tendon", ""}; }

IceLink::IceLink(std::shared_ptr<Ice::Connection> connection, std::uint64_t door)
    : connection_(std::move(connection)),
      peer_endpoint_(connection_->createProxy(EndpointIdentity())->ice_oneway()),
      door_(door),
      peer_(PeerOf(*connection_)) {}

Status IceLink::Send(std::span<const std::byte> frame) {
  if (!ReadWholeFrame(frame)) return Status::kInvalid;
  const std::size_t size = frame.size();
  {
    const std::scoped_lock lock(mutex_);
    if (reason_) return Status::kNotConnected;
    if (unsent_ != 0 && unsent_ + size > kSendWindow) return Status::kQueueFull;
    unsent_ += size;
  }
  constexpr std::size_t kKept = std::size_t{1} << 20U;
  thread_local Bytes parameters;
  WriteOnlyParameter(frame, parameters);
  const auto* begin = reinterpret_cast<const Ice::Byte*>(parameters.data());
  const std::pair<const Ice::Byte*, const Ice::Byte*> range{begin, begin + parameters.size()};
  const auto sent = [self = shared_from_this(), size](bool /*at once*/) { self->OnSent(size); };
  const auto failed = [self = shared_from_this(), size](const std::exception_ptr& /*why*/) {
    self->OnSent(size);
  };
  try {
    peer_endpoint_->ice_invokeAsync("frame", Ice::OperationMode::Normal, range, nullptr, failed,
                                    sent);
  } catch (const Ice::Exception&) {
    OnSent(size);
    return Status::kNotConnected;
  }
  if (parameters.capacity() > kKept) Bytes().swap(parameters);
  return Status::kQueued;
}

void IceLink::OnSent(std::size_t size) {
  const std::scoped_lock lock(mutex_);
  unsent_ -= size;
}

bool IceLink::StartClosing(const Error& reason) {
  const std::scoped_lock lock(mutex_);
  if (reason_) return false;
  reason_ = reason;
  return true;
}

void IceLink::Close() {
  Fail({ErrorCode::kUnreachable, "the connection to " + peer_ + " was closed here"});
}

void IceLink::Fail(const Error& reason) {
  if (StartClosing(reason)) connection_->close(Ice::ConnectionClose::Gracefully);
}

void IceLink::CloseAtOnce() {
  StartClosing({ErrorCode::kUnreachable, "the connection to " + peer_ + " was closed here"});
  connection_->close(Ice::ConnectionClose::Forcefully);
}

void IceLink::SetHandler(std::shared_ptr<LinkHandler> handler) {
  const std::scoped_lock lock(delivery_);
  handler_ = std::move(handler);
}

void IceLink::Deliver(std::span<const std::byte> frame) {
  const std::scoped_lock delivery(delivery_);
  {
    const std::scoped_lock lock(mutex_);
    if (reason_) return;
  }
  if (handler_) handler_->OnFrame(frame);
}

void IceLink::OnGone() {
  StartClosing({ErrorCode::kUnreachable, peer_ + " closed the connection"});
  const std::scoped_lock delivery(delivery_);  // after the last frame
  if (const auto handler = std::exchange(handler_, nullptr)) handler->OnClosed(*reason_);
}

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

std::shared_ptr<IceLink> Links::Find(const std::shared_ptr<Ice::Connection>& connection) {
  const std::scoped_lock lock(mutex_);
  const auto found = links_.find(connection.get());
  return found == links_.end() ? nullptr : found->second;
}

void Links::CloseAll(std::uint64_t door) {
  const auto is_meant = [door](const auto& one) { return door == 0 || one.second->door_ == door; };
  std::vector<std::shared_ptr<IceLink>> meant;
  std::unique_lock lock(mutex_);
  if (door == 0) is_shut_ = true;
  for (const auto& one : links_) {
    if (is_meant(one)) meant.push_back(one.second);
  }
  lock.unlock();
  for (const auto& link : meant) link->CloseAtOnce();
  lock.lock();
  changed_.wait(lock, [&] { return std::none_of(links_.begin(), links_.end(), is_meant); });
}

}  // namespace tendon::ice
