#include <tendon/middleware/channel.h>

#include <tendon/base/log.h>
#include <tendon/base/rate_limited_warning.h>
#include <tendon/middleware/connect_cancellation.h>
#include <tendon/middleware/large_message_in_progress.h>

#include <cassert>
#include <condition_variable>
#include <mutex>
#include <new>
#include <stop_token>
#include <thread>
#include <utility>

namespace tendon {
namespace {

/// The number of nested calls from a middleware that this thread is executing. If this is not 0,
/// the thread must not wait for a reply.
thread_local int calls_from_middleware = 0;

struct MiddlewareCallScope {
  MiddlewareCallScope() { ++calls_from_middleware; }
  MiddlewareCallScope(const MiddlewareCallScope&) = delete;
  MiddlewareCallScope& operator=(const MiddlewareCallScope&) = delete;
  ~MiddlewareCallScope() { --calls_from_middleware; }
};

/// Calls `give` every 250 ms in a separate thread, for at most LargeMessageInProgress::kAtMost.
/// `give` sends a sign of life to the peer while the middleware's thread handles a large message.
/// If the thread cannot be started, only logs the failure.
class ProgressSender {
 public:
  ProgressSender(const std::string& peer, std::function<void()> give) {
    CallGuarded(peer, [&] {
      thread_ = std::jthread([give = std::move(give)](const std::stop_token& stop) {
        constexpr std::chrono::milliseconds kBetween(250);
        std::mutex mutex;
        std::condition_variable_any never;
        std::unique_lock lock(mutex);
        const SteadyTime end = SteadyClock().Now() + LargeMessageInProgress::kAtMost;
        while (!never.wait_for(lock, stop, kBetween, [&] { return stop.stop_requested(); }) &&
               SteadyClock().Now() < end) {
          give();
        }
      });
    });
  }

 private:
  std::jthread thread_;
};

/// Returns true if the peer is on this machine. An invalid address counts as on this machine,
/// because this case has the stricter checks.
bool IsOnThisMachine(const Link& link) {
  const auto address = ParseAddress(link.peer(), 0);
  return !address || CheckExposure(address->host, Exposure::kLoopbackOnly).ok();
}

/// Returns the Hello for the handshake on `link`. The Hello has the cookie only if the peer is on
/// this machine and the link has no TLS, which needs no cookie.
Hello For(const Link& link, Hello mine) {
  if (link.certificate() != nullptr || !IsOnThisMachine(link)) mine.cookie = 0;
  return mine;
}

/// Copies a reply. If there is not enough memory, only this reply is lost.
Result<Reply> CopyOf(std::span<const std::byte> reply) {
  try {
    return Reply(Bytes(reply.begin(), reply.end()));
  } catch (const std::bad_alloc&) {
    return Error{ErrorCode::kFailed, "there is not enough memory for the reply"};
  }
}

}  // namespace

Channel::Channel(Key /*only from here*/, Hello mine, std::shared_ptr<ChannelHandler> handler,
                 std::shared_ptr<Link> link, UnauthenticatedPeers unauthenticated)
    : mine_(std::move(mine)),
      is_acceptor_(link != nullptr),
      handler_(std::move(handler)),
      incoming_parts_([this](const FrameHeader& header) { return IsWanted(header); }),
      link_(std::move(link)) {
  if (!link_) return;
  handshake_.emplace(
      Handshake::Role::kAcceptor, For(*link_, mine_), link_->local(),
      IsOnThisMachine(*link_) ? unauthenticated : UnauthenticatedPeers::kFromElsewhere,
      link_->certificate());
}

Result<std::shared_ptr<Channel>> Channel::Open(Middleware& middleware, const std::string& address,
                                               const Hello& mine,
                                               std::shared_ptr<ChannelHandler> handler,
                                               std::chrono::milliseconds timeout) {
  const SteadyTime deadline = SteadyClock().Now() + timeout;
  auto channel = std::make_shared<Channel>(Key{}, mine, std::move(handler), nullptr,
                                           UnauthenticatedPeers::kRefused);
  const auto link = middleware.Open(address, channel->AsLinkHandler(), timeout);
  if (!link) return link.error();
  const auto greeted = channel->Greet(*link, deadline);
  if (!greeted) return greeted.error();
  return channel;
}

AcceptLink Channel::Acceptor(Hello mine, std::function<std::shared_ptr<ChannelHandler>()> choose,
                             UnauthenticatedPeers unauthenticated) {
  return [mine = std::move(mine), choose = std::move(choose),
          unauthenticated](const std::shared_ptr<Link>& link) -> std::shared_ptr<LinkHandler> {
    const MiddlewareCallScope mark;
    std::shared_ptr<LinkHandler> made;
    CallGuarded(link->peer(), [&] {
      auto handler = choose();
      if (!handler) return;
      made = std::make_shared<Channel>(Key{}, mine, std::move(handler), link, unauthenticated)
                 ->AsLinkHandler();
    });
    return made;
  };
}

std::shared_ptr<LinkHandler> Channel::AsLinkHandler() { return {shared_from_this(), this}; }

/// Does the handshake at the opener's end, and waits until it is done.
Result<void> Channel::Greet(const std::shared_ptr<Link>& link, SteadyTime deadline) {
  const CancellableConnect wait([this] {
    const std::scoped_lock lock(mutex_);
    if (greeted_ || reason_) return;
    is_open_.Set(false);
    reason_ = ConnectCancelledError();
    changed_.notify_all();
  });
  std::unique_lock lock(mutex_);
  link_ = link;
  handshake_.emplace(Handshake::Role::kOpener, For(*link, mine_), link->peer(),
                     UnauthenticatedPeers::kRefused, link->certificate());
  const Bytes greeting = handshake_->Greet();
  lock.unlock();
  (void)Send(MessageType::kHello, 1, 0, greeting);  // after a failure, OnClosed() is called
  lock.lock();
  if (!changed_.wait_until(lock, deadline, [&] { return greeted_ || reason_; })) {
    is_open_.Set(false);
    reason_ =
        Error{ErrorCode::kTimeout, link->peer() +
                                       " accepted the connection but did not answer in time: check "
                                       "that a program of Tendon listens at this address"};
  }
  if (greeted_) return {};
  const Error reason = *reason_;
  lock.unlock();
  link->Close();
  return reason;
}

void Channel::OnFrame(std::span<const std::byte> frame) { OnLentFrame(frame, nullptr); }

/// `owner` keeps the memory of the frame valid; null if the bytes are valid only during this call.
void Channel::OnLentFrame(std::span<const std::byte> frame, std::shared_ptr<const void> owner) {
  const MiddlewareCallScope mark;
  const auto header = ReadWholeFrame(frame);
  assert(header);
  const auto body = frame.subspan(FrameHeader::kSize);
  if (!is_open()) return OnFirst(*header, body);
  try {
    OnMessage(*header, body, std::move(owner));
    Resume();
  } catch (const std::bad_alloc&) {
    OnOutOfMemory("out of memory (ulimit -v)", frame.size());
  }
}

/// Closes the channel because there is not enough memory for one of its messages. All other
/// channels continue.
void Channel::OnOutOfMemory(const char* limit, std::size_t size) {
  static RateLimitedWarning warnings("channel");
  CallGuarded("channel", [&] {
    const std::string what =
        std::string(limit) + ": a message of " + std::to_string(size) + " bytes is refused";
    warnings.Add(what);
    Fail({ErrorCode::kFailed, what});
  });
}

/// Handles a frame of the handshake. Ignores frames that arrive after the channel was closed.
void Channel::OnFirst(const FrameHeader& header, std::span<const std::byte> body) {
  std::unique_lock lock(mutex_);
  if (reason_ || !link_) return;
  lock.unlock();
  CallGuarded(link_->peer(), [&] { OnGreeting(header, body); });
}

void Channel::OnDirectFrame(std::span<const std::byte> frame, ReplySlot& slot) {
  const CurrentRequest current(*this, ReadWholeFrame(frame)->request, slot);
  OnFrame(frame);
}

void Channel::OnGreeting(const FrameHeader& header, std::span<const std::byte> body) {
  const auto step = handshake_->Take(header, body);
  if (!step) {
    if (is_acceptor_) SendRefusal(header.request, step.error());
    return Fail(step.error());
  }
  if (step->peer) link_->Admit();
  if (step->has_reply && !Send(step->type, header.request, 0, step->body)) return;
  if (step->peer) Opened(*step->peer);
}

void Channel::Opened(Hello peer) {
  handshake_.reset();
  {
    const std::scoped_lock lock(mutex_);
    peer_ = std::move(peer);
    is_open_.Set(!reason_);
  }
  CallGuarded(peer_.name, [&] { handler_->OnOpen(shared_from_this(), peer_); });
  const std::scoped_lock lock(mutex_);
  greeted_ = true;
  changed_.notify_all();
}

void Channel::Fail(const Error& reason) {
  std::shared_ptr<Link> link;
  {
    const std::scoped_lock lock(mutex_);
    is_open_.Set(false);
    if (!reason_) reason_ = reason;
    link = link_;
    changed_.notify_all();
  }
  if (link) link->Close();
}

bool Channel::HasOurVersion(const FrameHeader& header) {
  if (header.version == FrameHeader::kProtocolVersion) return true;
  Fail({ErrorCode::kInvalid, peer_.name + " changed its protocol version"});
  return false;
}

void Channel::OnMessage(const FrameHeader& header, std::span<const std::byte> body,
                        std::shared_ptr<const void> owner) {
  if (!HasOurVersion(header)) return;
  switch (header.type) {
    case MessageType::kReply:
      requests_.Finish(header.request, owner ? Reply(body, std::move(owner)) : CopyOf(body));
      return;
    case MessageType::kReplies:
      return OnReplies(body);
    case MessageType::kRefusal:
      requests_.Finish(header.request, ReadRefusal(body, peer_.name));
      return;
    case MessageType::kHello:
    case MessageType::kChallenge:
    case MessageType::kProof:
    case MessageType::kWelcome:
      return Fail({ErrorCode::kInvalid, peer_.name + " said Hello twice"});
    case MessageType::kPart:
      return OnPart(header, body);
    case MessageType::kPartsTaken:
      return OnPartsTaken(body);
    default:
      break;
  }
  CallGuarded(peer_.name, [&] {
    if (header.request == 0) return handler_->OnNotice(shared_from_this(), header, body);
    handler_->OnRequest(shared_from_this(), header, body,
                        Responder(weak_from_this(), header.request));
  });
}

/// Checks the whole batch first. If the batch is malformed, none of its replies is used.
void Channel::OnReplies(std::span<const std::byte> body) {
  if (!IsReplyBatch(body)) {
    return Fail({ErrorCode::kInvalid, peer_.name + " sent malformed replies"});
  }
  while (const auto one = TakeReply(body)) {
    requests_.Finish(one->request, CopyOf(one->body));
  }
}

void Channel::OnPart(const FrameHeader& header, std::span<const std::byte> part) {
  using Progress = PartAssembly::Progress;
  PartAssembly::Frame frame;
  const Progress progress = incoming_parts_.Add(header.handle, part, frame);
  last_part_.Set(SteadyClock().Now());
  switch (progress) {
    case Progress::kMoreToCome:
      return;
    case Progress::kMalformed:
      return Fail({ErrorCode::kInvalid, peer_.name + " sent parts that are not a valid message"});
    case Progress::kOutOfMemory:
      return OnOutOfMemory("out of memory (ulimit -v)", FrameHeader::kSize + frame.header.size);
    case Progress::kTooMuch:
      return OnBudgetExceeded(frame.header);
    case Progress::kWhole:
      break;
  }
  ReportTakenParts();
  HandleLarge(std::move(frame));
}

/// Called if the budget for unfinished messages is used up. Refuses a request. A notice cannot be
/// refused, so the channel is closed; otherwise the notice would be lost silently.
void Channel::OnBudgetExceeded(const FrameHeader& header) {
  constexpr const char* kWhy = "512 MiB of unfinished messages are already kept";
  if (header.request == 0) return OnOutOfMemory(kWhy, FrameHeader::kSize + header.size);
  CallGuarded(peer_.name, [&] { SendRefusal(header.request, {ErrorCode::kFailed, kWhy}); });
}

/// Decides whether a large frame is stored. Called with its first part, so that a message of 64 MiB
/// can be refused before all of it is sent.
bool Channel::IsWanted(const FrameHeader& header) {
  if (header.type == MessageType::kReply || header.type == MessageType::kRefusal) {
    return requests_.IsAwaited(header.request);
  }
  std::optional<Error> refusal = Error{ErrorCode::kFailed, "the required role is unknown"};
  CallGuarded(peer_.name, [&] { refusal = handler_->RefusalOfLargeMessage(*this, header); });
  if (refusal && header.request != 0) SendRefusal(header.request, *refusal);
  return !refusal;
}

/// Handles a complete large message. This may take long, and the thread does not read from its
/// peers during this time. Therefore, a ProgressSender repeatedly reports to the peer how many
/// bytes have arrived. A reply is moved to its requester, not copied.
void Channel::HandleLarge(PartAssembly::Frame frame) {
  std::optional<LargeMessageInProgress> mark;
  std::optional<ProgressSender> sign;
  if (frame.body.size() >= LargeMessageInProgress::kMin) {
    mark.emplace();
    sign.emplace(peer_.name, [this] { SendTakenParts(); });
  }
  const FrameHeader& header = frame.header;
  if (header.type != MessageType::kReply) return OnMessage(header, frame.body);
  if (HasOurVersion(header)) requests_.Finish(header.request, Reply(std::move(frame.body)));
}

void Channel::OnPartsTaken(std::span<const std::byte> body) {
  const auto taken = DecodeBody<std::uint64_t>(body);
  last_part_.Set(SteadyClock().Now());
  if (taken && outgoing_parts_.OnTaken(*link_, *taken)) return;
  Fail({ErrorCode::kInvalid, peer_.name + " acknowledged more than was sent to it"});
}

void Channel::ReportTakenParts() {
  if (incoming_parts_.has_news()) SendTakenParts();
}

void Channel::SendTakenParts() {
  incoming_parts_.Report([this](std::uint64_t taken) {
    const Bytes body = EncodeBody(taken);
    return SendPiece(HeaderOf(MessageType::kPartsTaken, 0, 0, body.size()), body);
  });
}

/// Continues to send parts. Called after each sent or received frame, and regularly by Expire(),
/// because the link does not report when it has room again.
void Channel::Resume() {
  ReportTakenParts();
  outgoing_parts_.Resume(*link_);
}

void Channel::OnClosed(const Error& reason) {
  const MiddlewareCallScope mark;
  const std::string peer = PeerName();
  std::unique_lock lock(mutex_);
  is_open_.Set(false);
  if (!reason_) reason_ = reason;
  const Error why = *reason_;
  changed_.notify_all();
  lock.unlock();
  incoming_parts_.Clear();
  outgoing_parts_.Close();
  requests_.FinishAll(
      {ErrorCode::kUnreachable, peer + " did not answer: " + why.message + "; outcome unknown"});
  CallGuarded(peer, [&] { handler_->OnClosed(shared_from_this(), why); });
  handler_.reset();
}

FrameHeader Channel::HeaderOf(MessageType type, std::uint64_t request, std::uint32_t handle,
                              std::size_t size) {
  return {
      .type = type, .request = request, .size = static_cast<std::uint32_t>(size), .handle = handle};
}

Status Channel::Send(MessageType type, std::uint64_t request, std::uint32_t handle,
                     std::span<const std::byte> body, Lane lane, Delivery delivery) {
  const FrameHeader header = HeaderOf(type, request, handle, body.size());
  return SendBy(header, body, lane, [&] { return SendPiece(header, body, delivery); });
}

/// Sends the message in parts if necessary, otherwise calls `send_whole`.
template <typename SendWhole>
Status Channel::SendBy(const FrameHeader& header, std::span<const std::byte> body, Lane lane,
                       SendWhole send_whole) {
  if (body.size() > kMaxBodySize) return Status::kInvalid;
  if (outgoing_parts_.MustSendInParts(lane, FrameHeader::kSize + body.size())) {
    return outgoing_parts_.Add(*link_, lane, header, body);
  }
  const Status sent = send_whole();
  Resume();
  return sent;
}

Status Channel::SendPiece(const FrameHeader& header, std::span<const std::byte> body,
                          Delivery delivery) {
  thread_local Bytes frame;
  WriteFrame(header, body, frame);
  return link_->Send(frame, delivery);
}

Status Channel::Notify(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                       Lane lane) {
  return is_open() ? Send(type, 0, handle, body, lane) : Status::kNotConnected;
}

Status Channel::NotifyInPlace(MessageType type, std::uint32_t handle, std::span<std::byte> frame,
                              Lane lane) {
  assert(frame.size() >= FrameHeader::kSize);
  if (!is_open()) return Status::kNotConnected;
  const auto body = frame.subspan(FrameHeader::kSize);
  const FrameHeader header = HeaderOf(type, 0, handle, body.size());
  return SendBy(header, body, lane, [&] {
    WriteHeader(header, frame.first<FrameHeader::kSize>());
    return link_->Send(frame);
  });
}

Lane Channel::NewLane() {
  const std::scoped_lock lock(mutex_);
  return ++last_lane_;
}

void Channel::Request(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                      std::chrono::milliseconds timeout, ReplyHandler handler, Lane lane,
                      Delivery delivery) {
  const std::uint64_t request = is_open() ? requests_.Add(timeout, handler) : 0;
  if (request == 0) return handler(WhyNotSent(Status::kNotConnected, PeerName(), body.size()));
  const Status sent = Send(type, request, handle, body, lane, delivery);
  if (!sent) requests_.Finish(request, WhyNotSent(sent, PeerName(), body.size()));
}

Status Channel::TryRequest(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                           std::chrono::milliseconds timeout, ReplyHandler handler, Lane lane,
                           Delivery delivery) {
  const std::uint64_t request = is_open() ? requests_.Add(timeout, handler) : 0;
  if (request == 0) return Status::kNotConnected;
  const Status sent = Send(type, request, handle, body, lane, delivery);
  if (!sent) requests_.Withdraw(request);
  return sent;
}

bool Channel::IsThreadOfMiddleware() noexcept { return calls_from_middleware > 0; }

Result<Reply> Channel::Call(MessageType type, std::uint32_t handle, std::span<const std::byte> body,
                            std::chrono::milliseconds timeout, Lane lane, Delivery delivery) {
  if (IsThreadOfMiddleware()) {
    return Error{ErrorCode::kFailed, "a call to " + PeerName() + " would wait for its own thread"};
  }
  const SteadyTime deadline = SteadyClock().Now() + timeout;
  BlockingRequest reply(requests_);
  const Status sent = is_open() && reply.number() != 0
                          ? Send(type, reply.number(), handle, body, lane, delivery)
                          : Status(Status::kNotConnected);
  if (!sent) return WhyNotSent(sent, PeerName(), body.size());
  if (auto outcome = reply.WaitUntil(deadline)) return *std::move(outcome);
  return NoReply(PeerName(), timeout);
}

/// Returns true if a reply of this size may be sent as the response to a direct request. A response
/// is not sent in parts, so it must be small or the link must be fast.
bool Channel::FitsInSlot(std::size_t size) {
  if (!outgoing_parts_.MustSendInParts(kOwnLane, size)) return true;
  return size <= kMaxReturned && outgoing_parts_.is_quick();
}

/// Returns false if the reply was not sent.
bool Channel::SendReply(std::uint64_t request, std::span<const std::byte> body, Lane lane) {
  const Status sent = Send(MessageType::kReply, request, 0, body, lane);
  if (sent || sent == Status::kNotConnected) return bool(sent);
  const Error why = WhyNotSent(sent, PeerName(), body.size());
  Log(LogLevel::kWarning, "channel", "a reply was lost: " + why.message);
  SendRefusal(request, why);
  return false;
}

void Channel::SendRefusal(std::uint64_t request, const Error& error) {
  // If the link has no room for the refusal either, the request of the peer times out.
  (void)Send(MessageType::kRefusal, request, 0, EncodeBody(error));
}

void Channel::Expire(SteadyTime now) {
  requests_.Expire(now, PeerName());
  if (!is_open()) return;
  if (incoming_parts_.IsUnfinishedTooLong(now))
    return CutOff("began a message and did not finish it");
  Resume();
}

void Channel::Close() {
  Fail({ErrorCode::kUnreachable, "the connection was closed by this program"});
}

void Channel::CutOff(const std::string& what) {
  Fail({ErrorCode::kInvalid, PeerName() + " was disconnected: it " + what});
}

std::string Channel::peer_address() const {
  const std::scoped_lock lock(mutex_);
  return link_ ? link_->peer() : std::string();
}

std::string Channel::PeerName() const {
  const std::scoped_lock lock(mutex_);
  if (!peer_.name.empty()) return peer_.name;
  return link_ ? link_->peer() : "the peer";
}

}  // namespace tendon
