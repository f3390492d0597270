#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/body.h>
#include <tendon/middleware/channel_handler.h>
#include <tendon/middleware/handshake.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>
#include <tendon/middleware/part_receiver.h>
#include <tendon/middleware/part_sender.h>
#include <tendon/middleware/payload_limit.h>
#include <tendon/middleware/pending_requests.h>
#include <tendon/middleware/reply_batch.h>
#include <tendon/middleware/responder.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tendon {

/// A two-way connection with one peer process, over one link. After the handshake, both ends can
/// send notices, which have no reply, and requests, which have exactly one reply.
///
/// A body has at most kMaxBodySize bytes. A message that is too large for one frame is sent in
/// parts. Messages on other lanes are sent between these parts; messages on the same lane wait
/// until the last part is sent.
///
/// A channel lives until either end closes it or its middleware is destroyed. Thread-safe.
///
/// The channel uses these classes:
/// - Handshake authenticates the peer. The handler gets no message before that.
/// - PendingRequests holds the requests of this end until a reply, a refusal or the timeout.
/// - PartSender sends a large message of this end in parts, as fast as the peer acknowledges them.
///   PartReceiver joins the parts that the peer sends.
/// - ChannelHandler, written by the owner, receives the notices and requests of the peer. It
///   replies to a request with a Responder, now or later. A ReplyBatcher sends many replies in one
///   message.
class Channel final : public std::enable_shared_from_this<Channel>, private LinkHandler {
  struct Key {};

 public:
  /// Opens a link and does the handshake; blocks for at most `timeout`. Fails like
  /// Middleware::Open(). Also fails if the peer refuses: with kIncompatible for another protocol
  /// version, and with kDenied for a wrong cookie. Must not be called in a thread of the
  /// middleware.
  static Result<std::shared_ptr<Channel>> Open(Middleware& middleware, const std::string& address,
                                               const Hello& mine,
                                               std::shared_ptr<ChannelHandler> handler,
                                               std::chrono::milliseconds timeout);

  /// Returns a function for Middleware::Listen() that makes a channel from every new link. `choose`
  /// returns the handler of the channel, or null to refuse the link. Peers on this machine must
  /// know the cookie in `mine`, unless `unauthenticated` admits peers without it.
  static AcceptLink Acceptor(Hello mine, std::function<std::shared_ptr<ChannelHandler>()> choose,
                             UnauthenticatedPeers unauthenticated = UnauthenticatedPeers::kRefused);

  /// Sends a notice; never blocks. Fails like Link::Send().
  Status Notify(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                Lane lane = kCommonLane);
  template <Message T>
  Status Notify(MessageType type, std::uint32_t handle, const T& value, Lane lane = kCommonLane);
  /// Sends a notice like Notify(), but without copying the body. The caller has written the body
  /// into `frame` from position FrameHeader::kSize on; the header is written in front of it.
  Status NotifyInPlace(MessageType type, std::uint32_t handle, std::span<std::byte> frame,
                       Lane lane = kCommonLane);

  /// Returns a new lane for messages from this end. No other lane of this end has the same number.
  [[nodiscard]] Lane NewLane();

  using ReplyHandler = PendingRequests::Handler;

  /// Sends a request; never blocks. Calls the handler exactly once: in a thread of the middleware,
  /// in Expire(), or before this function returns if the request could not be sent. The handler
  /// receives the reply, the refusal of the peer, kTimeout (outcome unknown), or kUnreachable if
  /// the channel was closed before the reply.
  void Request(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
               std::chrono::milliseconds timeout, ReplyHandler handler, Lane lane = kCommonLane,
               Delivery delivery = Delivery::kQueued);
  /// Like Request(), but never calls the handler if the request cannot be sent now. Instead, fails
  /// like Link::Send().
  Status TryRequest(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                    std::chrono::milliseconds timeout, ReplyHandler handler,
                    Lane lane = kCommonLane, Delivery delivery = Delivery::kQueued);
  template <Payload ReplyBody, Message T>
  void Request(MessageType type, std::uint32_t handle, const T& value,
               std::chrono::milliseconds timeout, std::function<void(Result<ReplyBody>)> handler,
               Lane lane = kCommonLane);

  /// Returns true if a middleware is calling a handler in this thread. Such a thread must not wait
  /// for a reply.
  [[nodiscard]] static bool IsThreadOfMiddleware() noexcept;

  /// Sends a request and waits for the reply. Fails in a thread of the middleware. A large reply
  /// is not copied.
  Result<Reply> Call(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                     std::chrono::milliseconds timeout, Lane lane = kCommonLane,
                     Delivery delivery = Delivery::kQueued);
  template <Payload ReplyBody, Message T>
  Result<ReplyBody> Call(MessageType type, std::uint32_t handle, const T& value,
                         std::chrono::milliseconds timeout);

  /// Ends requests that have timed out. Closes the channel if the peer has stopped in the middle of
  /// a large message. The owner of the channel must call it regularly; MonitorPeer() and
  /// KeepExpiring() do this. Call() has its own timer.
  void Expire(SteadyTime now);

  /// Closes the channel. ChannelHandler::OnClosed() is called later. Idempotent; may be called from
  /// a handler.
  void Close();
  /// Closes the channel because the peer misbehaves or does not answer. `what` describes the fault
  /// of the peer and becomes part of the reason: "has not answered for 2 s".
  void CutOff(const std::string& what);

  /// Wait-free.
  [[nodiscard]] bool is_open() const { return is_open_.Get(); }
  /// The peer's Hello; empty before OnOpen().
  [[nodiscard]] const Hello& peer() const { return peer_; }
  [[nodiscard]] std::string peer_address() const;
  /// The last time when a part of a large message arrived, or when the peer acknowledged a part. If
  /// this was recent, the peer is alive, even if its other messages are late because of the parts.
  [[nodiscard]] SteadyTime last_part() const { return last_part_.Get(); }

  /// `link` is an accepted link, or null if this end opens the link.
  Channel(Key key, Hello mine, std::shared_ptr<ChannelHandler> handler, std::shared_ptr<Link> link,
          UnauthenticatedPeers unauthenticated);

 private:
  friend class ReplyBatcher;
  friend class Responder;

  // Called by the link.
  void OnFrame(std::span<const std::byte> frame) override;
  void OnLentFrame(std::span<const std::byte> frame, std::shared_ptr<const void> owner) override;
  void OnDirectFrame(std::span<const std::byte> frame, ReplySlot& slot) override;
  void OnClosed(const Error& reason) override;
  [[nodiscard]] std::shared_ptr<LinkHandler> AsLinkHandler();

  // Do the handshake.
  Result<void> Greet(const std::shared_ptr<Link>& link, SteadyTime deadline);
  void OnFirst(const FrameHeader& header, std::span<const std::byte> body);
  void OnGreeting(const FrameHeader& header, std::span<const std::byte> body);
  void Opened(Hello peer);

  // Handle messages of the peer.
  void OnMessage(const FrameHeader& header, std::span<const std::byte> body,
                 std::shared_ptr<const void> owner = nullptr);
  [[nodiscard]] bool HasOurVersion(const FrameHeader& header);
  void OnReplies(std::span<const std::byte> body);

  // Handle large messages of the peer, which arrive in parts.
  void OnPart(const FrameHeader& header, std::span<const std::byte> part);
  [[nodiscard]] bool IsWanted(const FrameHeader& header);
  void HandleLarge(PartAssembly::Frame frame);
  void ReportTakenParts();
  void SendTakenParts();
  void OnBudgetExceeded(const FrameHeader& header);
  void OnOutOfMemory(const char* limit, std::size_t size);

  // Send messages to the peer, whole or in parts.
  Status Send(MessageType type, std::uint64_t request, std::uint32_t handle,
              std::span<const std::byte> body, Lane lane = kCommonLane,
              Delivery delivery = Delivery::kQueued);
  template <typename SendWhole>
  Status SendBy(const FrameHeader& header, std::span<const std::byte> body, Lane lane,
                SendWhole send_whole);
  Status SendPiece(const FrameHeader& header, std::span<const std::byte> body,
                   Delivery delivery = Delivery::kQueued);
  [[nodiscard]] static FrameHeader HeaderOf(MessageType type, std::uint64_t request,
                                            std::uint32_t handle, std::size_t size);
  void OnPartsTaken(std::span<const std::byte> body);
  void Resume();

  // Send replies to the peer. Used by Responder and ReplyBatcher.
  [[nodiscard]] bool FitsInSlot(std::size_t size);
  bool SendReply(std::uint64_t request, std::span<const std::byte> body, Lane lane);
  void SendRefusal(std::uint64_t request, const Error& error);

  void Fail(const Error& reason);
  [[nodiscard]] std::string PeerName() const;

  const Hello mine_;
  const bool is_acceptor_;
  std::shared_ptr<ChannelHandler> handler_;  // used only in the middleware's thread
  // Used only in the middleware's thread; set when the link exists.
  std::optional<Handshake> handshake_;
  PendingRequests requests_;
  PartReceiver incoming_parts_;
  PartSender outgoing_parts_;
  Published<SteadyTime> last_part_;

  Flag is_open_;  // set from the end of the handshake until reason_ is set

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<Link> link_;
  Hello peer_;            // does not change after the channel is open
  bool greeted_ = false;  // set after OnOpen()
  Lane last_lane_ = kCommonLane;
  std::optional<Error> reason_;  // the reason why the channel is closed or is being closed
};

template <Message T>
Status Channel::Notify(MessageType type, std::uint32_t handle, const T& value, Lane lane) {
  return Notify(type, handle, std::span<const std::byte>(EncodeBody(value)), lane);
}

template <Payload ReplyBody, Message T>
void Channel::Request(MessageType type, std::uint32_t handle, const T& value,
                      std::chrono::milliseconds timeout,
                      std::function<void(Result<ReplyBody>)> handler, Lane lane) {
  Request(
      type, handle, std::span<const std::byte>(EncodeBody(value)), timeout,
      [handler = std::move(handler)](Result<Bytes> reply) {
        handler(reply ? DecodeBody<ReplyBody>(*reply) : Result<ReplyBody>(reply.error()));
      },
      lane);
}

template <Payload ReplyBody, Message T>
Result<ReplyBody> Channel::Call(MessageType type, std::uint32_t handle, const T& value,
                                std::chrono::milliseconds timeout) {
  const auto reply = Call(type, handle, std::span<const std::byte>(EncodeBody(value)), timeout);
  if (!reply) return reply.error();
  return DecodeBody<ReplyBody>(reply->body());
}

}  // namespace tendon
