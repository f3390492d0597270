#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/body.h>
#include <tendon/middleware/channel_handler.h>
#include <tendon/middleware/handshake/handshake.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>
#include <tendon/middleware/parts/lane.h>
#include <tendon/middleware/parts/part_assembly.h>
#include <tendon/middleware/parts/part_sender.h>
#include <tendon/middleware/parts/payload_limit.h>
#include <tendon/middleware/requests/answer.h>
#include <tendon/middleware/requests/pending_requests.h>
#include <tendon/middleware/requests/reply_batch.h>
#include <tendon/middleware/requests/responder.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace tendon {

/// Two-way talk with one peer process, on one link, after both said Hello: notices, which are one
/// way, and requests, which are answered exactly once.
///
/// A body may have kMaxBodySize. What is too large for one piece is sent in parts, between which
/// other messages pass, unless they are of the same lane.
///
/// A channel lives until it is closed, by either end, or its middleware is destroyed. Thread-safe.
class Channel final : public std::enable_shared_from_this<Channel>, private LinkHandler {
  struct Key {};

 public:
  /// Opens a link and shakes hands; blocks for at most `timeout`. Errors are those of
  /// Middleware::Open() and the peer's refusals: kIncompatible (protocol versions), kDenied
  /// (cookie). Never from a thread of the middleware.
  static Result<std::shared_ptr<Channel>> Open(Middleware& middleware, const std::string& address,
                                               const Hello& mine,
                                               std::shared_ptr<ChannelHandler> handler,
                                               std::chrono::milliseconds timeout);

  /// For Middleware::Listen(): makes a channel of every link; `choose` gives its handler, or null
  /// to refuse it. Peers on this machine must know the cookie in `mine`; allowed strangers need
  /// none.
  static AcceptLink Acceptor(Hello mine, std::function<std::shared_ptr<ChannelHandler>()> choose,
                             Strangers strangers = Strangers::kRefused);

  /// One way; never blocks. Refusals as of Link::Send().
  Status Notify(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                Lane lane = kCommonLane);
  template <Message T>
  Status Notify(MessageType type, std::uint32_t handle, const T& value, Lane lane = kCommonLane);

  /// One that nobody else has, for messages of this end.
  [[nodiscard]] Lane NewLane();

  using ReplyHandler = PendingRequests::Handler;

  /// Asks; never blocks. The handler is called exactly once, in a thread of the middleware, that of
  /// Expire() or, when nothing could be sent, this one: with the reply, the refusal, kTimeout
  /// (outcome unknown) or kUnreachable (closed before an answer).
  void Request(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
               std::chrono::milliseconds timeout, ReplyHandler handler, Lane lane = kCommonLane);
  /// The same, but of what cannot be sent now the handler is not called. Refusals as of
  /// Link::Send().
  Status TryRequest(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                    std::chrono::milliseconds timeout, ReplyHandler handler,
                    Lane lane = kCommonLane);
  template <Payload Reply, Message T>
  void Request(MessageType type, std::uint32_t handle, const T& value,
               std::chrono::milliseconds timeout, std::function<void(Result<Reply>)> handler,
               Lane lane = kCommonLane);

  /// TryRequest() for what is answered at once, as far as the peer can, to a caller that waits: by
  /// Link::Ask().
  Status TryAsk(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                std::chrono::milliseconds timeout, ReplyHandler handler, Lane lane = kCommonLane);

  /// Whether this thread is inside a call from a middleware: it must not wait for an answer.
  [[nodiscard]] static bool IsThreadOfMiddleware() noexcept;

  /// Asks and waits. Refused in a thread of the middleware, which would wait for itself.
  Result<Bytes> Call(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                     std::chrono::milliseconds timeout, Lane lane = kCommonLane);
  /// The same for what is answered at once. A large answer is where it has arrived.
  Result<Answer> Ask(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                     std::chrono::milliseconds timeout, Lane lane = kCommonLane);
  template <Payload Reply, Message T>
  Result<Reply> Call(MessageType type, std::uint32_t handle, const T& value,
                     std::chrono::milliseconds timeout);

  /// Ends the requests whose time has come, and the channel where the peer began a large message
  /// and does not go on with it; the owner calls it now and then, as WatchOver() and KeepExpiring()
  /// do. Call() needs none.
  void Expire(SteadyTime now);

  /// Idempotent; may be called from a handler, which hears OnClosed() later.
  void Close();
  /// The same, for the peer cannot be believed or does not answer: `what` it did is part of the
  /// reason.
  void CutOff(const std::string& what);

  /// Wait-free.
  [[nodiscard]] bool is_open() const { return is_open_.Get(); }
  /// The version of all that is said here, which both ends speak: what only newer ones have is
  /// kept from an older peer. Constant since it is open.
  [[nodiscard]] std::uint16_t protocol_version() const { return version_; }
  /// The peer's Hello; empty before OnOpen().
  [[nodiscard]] const Hello& peer() const { return peer_; }
  [[nodiscard]] std::string peer_address() const;
  /// When a part of a large message last arrived, or was last said to have been taken: whatever
  /// else is sent waits behind parts, and a peer that takes them, or handles what they make, lives.
  [[nodiscard]] SteadyTime last_part() const { return last_part_.Get(); }
  /// Answers that came after their requests had ended.
  [[nodiscard]] std::uint64_t late_replies() const;

  /// `link` is one that was accepted, or null.
  Channel(Key key, Hello mine, std::shared_ptr<ChannelHandler> handler, std::shared_ptr<Link> link,
          Strangers strangers);

 private:
  friend class GatheredReplies;
  friend class Responder;
  /// How a frame goes to the link.
  using Way = Status (Link::*)(std::span<const std::byte> frame);

  void OnFrame(std::span<const std::byte> frame) override;
  void OnLentFrame(std::span<const std::byte> frame, std::shared_ptr<const void> owner) override;
  void OnAsked(std::span<const std::byte> frame, LeftAnswer& answer) override;
  void OnClosed(const Error& reason) override;
  void OnNoRoom(const char* limit, std::size_t size);
  void OnTooMuch(const FrameHeader& header);

  Result<void> Greet(const std::shared_ptr<Link>& link, SteadyTime deadline);
  void OnFirst(const FrameHeader& header, std::span<const std::byte> body);
  void OnGreeting(const FrameHeader& header, std::span<const std::byte> body);
  [[nodiscard]] bool IsInAgreedVersion(const FrameHeader& header);
  void OnMessage(const FrameHeader& header, std::span<const std::byte> body,
                 std::shared_ptr<const void> owner = nullptr);
  void OnReplies(std::span<const std::byte> body);
  void OnPart(const FrameHeader& header, std::span<const std::byte> part);
  [[nodiscard]] bool IsWanted(const FrameHeader& header);
  [[nodiscard]] bool IsUnfinishedTooLong(SteadyTime now) const;
  void OnPartsTaken(std::span<const std::byte> body);
  void TellTaken();
  void SendTaken();
  void HandleLarge(PartAssembly::Frame frame);
  void Resume();
  void Opened(Hello peer);
  void Fail(const Error& reason);

  [[nodiscard]] FrameHeader HeaderOf(MessageType type, std::uint64_t request, std::uint32_t handle,
                                     std::size_t size) const;
  Status Send(MessageType type, std::uint64_t request, std::uint32_t handle,
              std::span<const std::byte> body, Lane lane = kCommonLane, Way way = &Link::Send);
  Status SendPiece(const FrameHeader& header, std::span<const std::byte> body,
                   Way way = &Link::Send);
  [[nodiscard]] bool MayReturn(std::size_t size);
  [[nodiscard]] LeftAnswer* WayBack(std::uint64_t request, std::size_t size, LeftAnswer* later);
  std::span<std::byte> BeginReply(std::uint64_t request, std::size_t size, LeftAnswer* later);
  void EndReply(std::uint64_t request, LeftAnswer* later);
  bool Return(std::uint64_t request, std::span<const std::byte> body, LeftAnswer* later);
  bool SendReply(std::uint64_t request, std::span<const std::byte> body, Lane lane,
                 LeftAnswer* later);
  bool SendReplyAlone(std::uint64_t request, std::span<const std::byte> body, Lane lane);
  void SendReplies(const ReplyBatch& batch);
  void SendRefusal(std::uint64_t request, const Error& error);
  Status TryStart(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                  std::chrono::milliseconds timeout, ReplyHandler handler, Lane lane, Way way);
  Result<Answer> Await(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                       std::chrono::milliseconds timeout, Lane lane, Way way);
  [[nodiscard]] std::string PeerName() const;
  [[nodiscard]] std::shared_ptr<LinkHandler> AsLinkHandler();

  const Hello mine_;
  std::uint16_t version_;  // of our frames: the oldest until it is open
  const bool is_acceptor_;
  std::shared_ptr<ChannelHandler> handler_;  // used in the middleware's thread only
  std::optional<Handshake> handshake_;       // likewise, once there is a link
  PartAssembly assembly_;                    // likewise
  PendingRequests requests_;
  PartSender parts_;
  Published<std::uint64_t> taken_{0};  // bytes of parts
  Published<std::uint64_t> told_taken_{0};
  Published<SteadyTime> last_part_;
  Published<SteadyTime> given_up_{SteadyTime::max()};  // of the assembly_
  std::mutex telling_;

  Flag is_open_;  // from the end of the handshake on, while there is no reason_

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::shared_ptr<Link> link_;
  Hello peer_;            // constant since it is open
  bool greeted_ = false;  // after OnOpen()
  Lane last_lane_ = kCommonLane;
  std::optional<Error> reason_;  // why it is closed, or about to be
};

template <Message T>
Status Channel::Notify(MessageType type, std::uint32_t handle, const T& value, Lane lane) {
  return Notify(type, handle, std::span<const std::byte>(EncodeBody(value)), lane);
}

template <Payload Reply, Message T>
void Channel::Request(MessageType type, std::uint32_t handle, const T& value,
                      std::chrono::milliseconds timeout, std::function<void(Result<Reply>)> handler,
                      Lane lane) {
  Request(
      type, handle, std::span<const std::byte>(EncodeBody(value)), timeout,
      [handler = std::move(handler)](Result<Bytes> reply) {
        handler(reply ? DecodeBody<Reply>(*reply) : Result<Reply>(reply.error()));
      },
      lane);
}

template <Payload Reply, Message T>
Result<Reply> Channel::Call(MessageType type, std::uint32_t handle, const T& value,
                            std::chrono::milliseconds timeout) {
  const auto reply = Call(type, handle, std::span<const std::byte>(EncodeBody(value)), timeout);
  if (!reply) return reply.error();
  return DecodeBody<Reply>(*reply);
}

}  // namespace tendon
