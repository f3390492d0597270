#include <tendon/ice/ice_link.h>

#include <tendon/base/os/socket.h>
#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/connection_socket.h>
#include <tendon/ice/outgoing_message.h>
#include <tendon/ice/tls.h>
#include <tendon/middleware/body.h>

#include <utility>

namespace tendon::ice {
namespace {

SocketAddresses AddressesIfOpen(const Ice::Connection& connection) {
  try {
    if (const auto address = AddressIn(connection.getInfo())) return AddressesOf(*address);
  } catch (const Ice::Exception&) {
    // The connection is already closed.
  }
  return {};
}

/// Returns the text of the exception that the peer threw while it answered. Returns an empty text
/// if the link broke or is being closed.
std::string FailureOfPeer(const Ice::Exception& why) {
  if (const auto* unknown = dynamic_cast<const Ice::UnknownException*>(&why)) {
    return unknown->unknown;
  }
  return dynamic_cast<const Ice::RequestFailedException*>(&why) != nullptr ? why.what() : "";
}

/// Returns a refusal frame, which is delivered instead of the reply to `request`.
Bytes RefusalOf(const FrameHeader& request, const std::string& peer, const std::string& failure) {
  const Bytes body = EncodeBody(Error{
      ErrorCode::kFailed, peer + " failed while it answered: " + failure + "; outcome unknown"});
  FrameHeader header;
  header.type = MessageType::kRefusal;
  header.request = request.request;
  header.size = static_cast<std::uint32_t>(body.size());
  Bytes refusal;
  WriteFrame(header, body, refusal);
  return refusal;
}

/// Called before a link is closed. Returns true if sent data is being retransmitted without
/// acknowledgement. Then closing the socket resets the connection.
bool IsUnacknowledged(const std::string& local, const std::string& peer) {
  const auto here = ParseAddress(local, 1);
  const auto there = ParseAddress(peer, 1);
  return here && there && os::ResetIfUnacknowledged(here->port, there->port);
}

}  // namespace

IceLink::IceLink(std::shared_ptr<Ice::Connection> connection, std::uint64_t listener)
    : connection_(std::move(connection)),
      two_way_(connection_->createProxy(EndpointIdentity())),
      oneway_(two_way_->ice_oneway()),
      listener_(listener),
      peer_(AddressesIfOpen(*connection_).peer),
      local_(AddressesIfOpen(*connection_).local),
      certificate_(CertificateOf(*connection_)) {}

/// Sends a frame with Delivery::kDirect as a two-way call of Ice, which can return an immediate
/// reply without a second message. The call is asynchronous, so no thread waits for the reply.
/// The acceptor queues all its frames, because its requests have no waiting callers.
Status IceLink::Send(std::span<const std::byte> frame, Delivery delivery) {
  const auto header = ReadWholeFrame(frame, kMaxPieceSize);
  if (!header) return Status::kInvalid;
  if (delivery == Delivery::kQueued || listener_ != 0) return Begin(oneway_, "frame", frame);
  return Begin(two_way_, "ask", frame, *header);
}

/// Begins to send one message. `request` is the header if this is a direct request.
Status IceLink::Begin(const std::shared_ptr<Ice::ObjectPrx>& peer, const std::string& operation,
                      std::span<const std::byte> bytes, const std::optional<FrameHeader>& request) {
  const auto message = std::make_shared<OutgoingMessage>(
      peer, shared_from_this(), OutgoingMessage::SendAccounting{bytes.size(), returned_.value()},
      request);
  if (const Status may = Enter(bytes.size()); !may) return may;
  try {
    message->Send(operation, bytes);
  } catch (const Ice::Exception&) {
    std::size_t size = bytes.size();
    OnNotSent(size);
    return Status::kNotConnected;
  }
  return Status::kQueued;
}

Status IceLink::Enter(std::size_t size) {
  const std::scoped_lock lock(mutex_);
  if (reason_) return Status::kNotConnected;
  if (unsent_ != 0 && unsent_ + size > kSendWindow) return Status::kQueueFull;
  unsent_ += size;
  return Status::kQueued;
}

void IceLink::OnSent(std::size_t& size, std::uint64_t returned_before) {
  {
    const std::scoped_lock lock(mutex_);
    unsent_ -= std::exchange(size, 0);
    confirmed_.Set(std::max(confirmed_.Get(), returned_before));
  }
  is_marker_on_way_.Set(false);
}

void IceLink::OnNotSent(std::size_t& size) {
  const std::scoped_lock lock(mutex_);
  unsent_ -= std::exchange(size, 0);
}

void IceLink::OnFailed(std::size_t& size, const std::optional<FrameHeader>& request,
                       const Ice::Exception& why) {
  OnNotSent(size);
  const std::string failure = request ? FailureOfPeer(why) : std::string();
  if (!failure.empty()) Deliver(RefusalOf(*request, peer_, failure));
}

bool IceLink::StartClosing(const Error& reason) {
  const std::scoped_lock lock(mutex_);
  if (reason_) return false;
  reason_ = reason;
  limit_.Set(0);
  return true;
}

void IceLink::Close() {
  Fail({ErrorCode::kUnreachable, "the connection to " + peer_ + " was closed by this program"});
}

void IceLink::Fail(const Error& reason) {
  if (!StartClosing(reason)) return;
  pending_calls_.Release();  // because Ice does not close a connection with open calls
  const bool is_unacknowledged = listener_ == 0 && IsUnacknowledged(local_, peer_);
  connection_->close(is_unacknowledged ? Ice::ConnectionClose::Forcefully
                                       : Ice::ConnectionClose::Gracefully);
}

void IceLink::CloseAtOnce() {
  StartClosing(
      {ErrorCode::kUnreachable, "the connection to " + peer_ + " was closed by this program"});
  pending_calls_.Release();
  connection_->close(Ice::ConnectionClose::Forcefully);
}

void IceLink::SetHandler(std::shared_ptr<LinkHandler> handler) {
  const std::scoped_lock lock(delivery_);
  handler_ = std::move(handler);
}

void IceLink::Admit() {
  const std::scoped_lock lock(mutex_);
  if (!reason_) limit_.Set(kMaxPieceSize);
}

void IceLink::CheckAdmission() {
  if (limit_.Get() == kMaxPieceSize) return;
  Fail(NotAdmitted(peer_));
}

/// Sends a marker, which the peer ignores. When Ice reports that the marker was sent, all earlier
/// replies have been sent, too.
void IceLink::SendMarker() {
  if (is_marker_on_way_.Get()) return;
  is_marker_on_way_.Set(true);
  if (!Begin(oneway_, "ice_ping", {})) is_marker_on_way_.Set(false);
}

bool IceLink::DeliverDirect(std::span<const std::byte> frame, ReplySlot& slot) {
  const std::scoped_lock delivery(delivery_);
  const std::size_t limit = limit_.Get();
  if (limit == 0) return true;
  if (!ReadWholeFrame(frame, limit)) return false;
  if (!handler_) return true;
  if (OnWay() >= kMarkerThreshold) SendMarker();
  if (!MayReturn()) {
    handler_->OnFrame(frame);
    return true;
  }
  handler_->OnDirectFrame(frame, slot);
  CountReturned(slot.size());
  return true;
}

void IceLink::OnReply(std::size_t& size, std::span<const std::byte> reply,
                      std::shared_ptr<const void> owner) {
  OnNotSent(size);
  const auto frame = ReadOnlyParameter(reply);
  if (frame && (frame->empty() || Forward(*frame, kMaxFrameSize, std::move(owner)))) return;
  Fail(NoFrame(peer_));
}

bool IceLink::Deliver(std::span<const std::byte> frame) {
  return Forward(frame, kMaxPieceSize, nullptr);
}

/// Delivers a frame to the handler. An admitted peer may send frames of up to `most` bytes.
bool IceLink::Forward(std::span<const std::byte> frame, std::size_t most,
                      std::shared_ptr<const void> owner) {
  const std::scoped_lock delivery(delivery_);
  const std::size_t limit = limit_.Get();
  if (limit == 0) return true;
  if (!ReadWholeFrame(frame, limit == kMaxPieceSize ? most : limit)) return false;
  if (!handler_) return true;
  if (owner) {
    handler_->OnLentFrame(frame, std::move(owner));
  } else {
    handler_->OnFrame(frame);
  }
  return true;
}

void IceLink::OnGone() {
  StartClosing({ErrorCode::kUnreachable, peer_ + " closed the connection"});
  pending_calls_.Release();
  const std::scoped_lock delivery(delivery_);  // waits until the last frame is delivered
  if (const auto handler = std::exchange(handler_, nullptr)) handler->OnClosed(*reason_);
}

Ice::Identity EndpointIdentity() { return {"tendon", ""}; }

}  // namespace tendon::ice
