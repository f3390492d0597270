#include <tendon/base/os/socket.h>
#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/links.h>
#include <tendon/ice/tls.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tendon::ice {
namespace {

/// Null where there is none.
std::shared_ptr<Ice::IPConnectionInfo> AddressOf(const Ice::Connection& connection) {
  auto info = connection.getInfo();
  while (info->underlying) info = info->underlying;
  return std::dynamic_pointer_cast<Ice::IPConnectionInfo>(info);
}

/// The two ends of a connection's socket, as "host:port".
struct Ends {
  std::string local = "unknown";
  std::string peer = "unknown";
};

std::string Place(std::string host, int port) {
  constexpr std::string_view kMapped = "::ffff:";  // IPv4 on a socket of IPv6
  if (host.starts_with(kMapped)) host.erase(0, kMapped.size());
  return ToString(HostPort{std::move(host), static_cast<std::uint16_t>(port)});
}

Ends EndsOf(const Ice::Connection& connection) {
  try {
    if (const auto address = AddressOf(connection)) {
      return {.local = Place(address->localAddress, address->localPort),
              .peer = Place(address->remoteAddress, address->remotePort)};
    }
  } catch (const Ice::Exception&) {
    // It is closed already.
  }
  return {};
}

/// Of a link that is about to be closed.
bool IsUnheard(const std::string& local, const std::string& peer) {
  const auto here = ParseAddress(local, 1);
  const auto there = ParseAddress(peer, 1);
  return here && there && os::DropUnheard(here->port, there->port);
}

}  // namespace

Ice::Identity EndpointIdentity() { return {"tendon", ""}; }

void KeepFromPrograms(const Ice::Connection& connection) {
  try {
    const auto address = AddressOf(connection);
    if (!address) return;
    os::KeepFromPrograms(static_cast<std::uint16_t>(address->localPort),
                         static_cast<std::uint16_t>(address->remotePort));
  } catch (const Ice::Exception&) {
    // It is closed already.
  }
}

IceLink::IceLink(std::shared_ptr<Ice::Connection> connection, std::uint64_t door)
    : connection_(std::move(connection)),
      two_way_(connection_->createProxy(EndpointIdentity())),
      oneway_(two_way_->ice_oneway()),
      door_(door),
      peer_(EndsOf(*connection_).peer),
      local_(EndsOf(*connection_).local),
      certificate_(CertificateOf(*connection_)) {}

Status IceLink::Send(std::span<const std::byte> frame) {
  if (!ReadWholeFrame(frame)) return Status::kInvalid;
  const std::scoped_lock sending(sending_);
  if (const Status may = MaySend(frame.size()); !may) return may;
  while (frame.size() > kMaxMessageSize) {
    const Status sent = SendMessage("part", frame.first(kMaxMessageSize));
    if (!sent) return sent;
    frame = frame.subspan(kMaxMessageSize);
  }
  return SendMessage("frame", frame);
}

/// A two-way call of Ice, which brings the answer with it if there is one at once: no thread has to
/// send it by a call of its own. Nobody waits in Ice. Who accepted makes none: with one under way,
/// Ice would not close the connection of a peer that has vanished.
Status IceLink::Ask(std::span<const std::byte> frame) {
  if (door_ != 0 || frame.size() > kMaxMessageSize) return Send(frame);
  if (!ReadWholeFrame(frame)) return Status::kInvalid;
  const std::scoped_lock sending(sending_);
  if (const Status may = MaySend(frame.size()); !may) return may;
  return Invoke(
      two_way_, "ask", frame,
      [self = shared_from_this(), size = frame.size()](
          bool /*ok*/, const std::pair<const Ice::Byte*, const Ice::Byte*>& answer) {
        self->OnSent(size);
        self->OnAnswer(std::as_bytes(std::span(answer.first, answer.second)));
      },
      nullptr);
}

Status IceLink::MaySend(std::size_t size) {
  const std::scoped_lock lock(mutex_);
  if (reason_) return Status::kNotConnected;
  return unsent_ != 0 && unsent_ + size > kSendWindow ? Status::kQueueFull : Status::kQueued;
}

Status IceLink::SendMessage(const std::string& operation, std::span<const std::byte> bytes) {
  return Invoke(oneway_, operation, bytes, nullptr,
                [self = shared_from_this(), size = bytes.size()](bool /*at once*/) {
                  self->OnSent(size);
                  self->OnReturned(0);
                });
}

/// Either of the two must call OnSent(), where they are called.
template <typename Answered, typename Sent>
Status IceLink::Invoke(const std::shared_ptr<Ice::ObjectPrx>& peer, const std::string& operation,
                       std::span<const std::byte> bytes, Answered answered, Sent sent) {
  const std::size_t size = bytes.size();
  {
    const std::scoped_lock lock(mutex_);
    unsent_ += size;
  }
  thread_local Bytes parameters;
  WriteOnlyParameter(bytes, parameters);
  const auto* begin = reinterpret_cast<const Ice::Byte*>(parameters.data());
  const std::pair<const Ice::Byte*, const Ice::Byte*> range{begin, begin + parameters.size()};
  const auto failed = [self = shared_from_this(), size](const std::exception_ptr& /*why*/) {
    self->OnSent(size);
  };
  try {
    peer->ice_invokeAsync(operation, Ice::OperationMode::Normal, range, answered, failed, sent);
  } catch (const Ice::Exception&) {
    OnSent(size);
    return Status::kNotConnected;
  }
  return Status::kQueued;
}

void IceLink::OnSent(std::size_t size) {
  const std::scoped_lock lock(mutex_);
  unsent_ -= size;
}

bool IceLink::MayReturn() {
  constexpr std::size_t kMostReturned = std::size_t{1} << 20U;
  const std::scoped_lock lock(mutex_);
  return returned_ < kMostReturned;
}

void IceLink::OnReturned(std::size_t size) {
  const std::scoped_lock lock(mutex_);
  returned_ = size == 0 ? 0 : returned_ + size;
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
  if (!StartClosing(reason)) return;
  const bool is_unheard = door_ == 0 && IsUnheard(local_, peer_);
  connection_->close(is_unheard ? Ice::ConnectionClose::Forcefully
                                : Ice::ConnectionClose::Gracefully);
}

void IceLink::CloseAtOnce() {
  StartClosing({ErrorCode::kUnreachable, "the connection to " + peer_ + " was closed here"});
  connection_->close(Ice::ConnectionClose::Forcefully);
}

void IceLink::SetHandler(std::shared_ptr<LinkHandler> handler) {
  const std::scoped_lock lock(delivery_);
  handler_ = std::move(handler);
}

void IceLink::Admit() {
  {
    const std::scoped_lock lock(mutex_);
    limit_ = kMaxFrameSize;
  }
  connection_->setHeartbeatCallback(nullptr);
}

void IceLink::CheckAdmission() {
  constexpr std::chrono::seconds kPatience(3);
  if (door_ == 0 || SteadyClock().Now() - since_ < kPatience) return;
  {
    const std::scoped_lock lock(mutex_);
    if (limit_ == kMaxFrameSize) return;
  }
  Fail({ErrorCode::kTimeout, peer_ + " connected and did not say who it is for 3 s"});
}

/// Nothing where it is closed, and nothing is heard from it any more.
std::optional<std::size_t> IceLink::LimitOfOpen() {
  const std::scoped_lock lock(mutex_);
  return reason_ ? std::nullopt : std::optional(limit_);
}

bool IceLink::DeliverWhole(std::span<const std::byte> frame, Bytes* answer) {
  const std::scoped_lock delivery(delivery_);
  const auto limit = LimitOfOpen();
  if (!limit) return true;
  if (!ReadWholeFrame(frame) || frame.size() > *limit) return false;
  if (!handler_) return true;
  answer != nullptr ? handler_->OnAsked(frame, *answer) : handler_->OnFrame(frame);
  return true;
}

void IceLink::OnAnswer(std::span<const std::byte> answer) {
  const auto frame = ReadOnlyParameter(answer);
  if (frame && (frame->empty() || DeliverWhole(*frame, nullptr))) return;
  Fail(NoFrame(peer_));
}

bool IceLink::Deliver(std::span<const std::byte> bytes, bool is_end) {
  const std::scoped_lock delivery(delivery_);
  const auto limit = LimitOfOpen();
  if (!limit) return true;
  if (!is_end || !begun_.empty()) {
    if (!AddPart(bytes, *limit)) return false;
    if (!is_end) return true;
    bytes = begun_;
  }
  if (!ReadWholeFrame(bytes) || bytes.size() > *limit) return false;
  if (handler_) handler_->OnFrame(bytes);
  Bytes().swap(begun_);
  return true;
}

/// No more is kept than the frame's header claims, and that is no more than `limit`.
bool IceLink::AddPart(std::span<const std::byte> bytes, std::size_t limit) {
  const auto header = ReadFrameHeader(begun_.empty() ? bytes : begun_, limit);
  if (!header) return false;
  const std::size_t size = FrameHeader::kSize + header->size;
  if (begun_.size() + bytes.size() > size) return false;
  begun_.reserve(size);
  begun_.insert(begun_.end(), bytes.begin(), bytes.end());
  return true;
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
  // Ice closes what is silent; this is for one who sends heartbeats and nothing else.
  if (link->door_ != 0) {
    link->connection_->setHeartbeatCallback(
        [weak = std::weak_ptr(link)](const std::shared_ptr<Ice::Connection>&) {
          if (const auto still_there = weak.lock()) still_there->CheckAdmission();
        });
  }
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
