#include <tendon/base/log.h>
#include <tendon/middleware/channel.h>
#include <tendon/middleware/requests/current_request.h>
#include <tendon/middleware/requests/reply_batcher.h>

#include <algorithm>

namespace tendon {

/// True if a reply of this size may be the response to Link::Ask(). Such a reply is not sent in
/// parts, so it must be small, or the link fast.
bool Channel::MayReturn(std::size_t size) {
  if (!parts_.MustTake(kOwnLane, size)) return true;
  return size <= kMaxReturned && parts_.is_quick();
}

/// The slot for a reply of `size` bytes as the response to its request: `later`, or the slot of the
/// request that this thread handles. Null if the reply must be sent as a message.
ReplySlot* Channel::WayBack(std::uint64_t request, std::size_t size, ReplySlot* later) {
  ReplySlot* const answer = later != nullptr ? later : Asked::AnswerTo(request, *this);
  return answer != nullptr && MayReturn(FrameHeader::kSize + size) ? answer : nullptr;
}

std::span<std::byte> Channel::BeginReply(std::uint64_t request, std::size_t size,
                                         ReplySlot* later) {
  ReplySlot* const answer = WayBack(request, size, later);
  if (answer == nullptr) return {};
  const auto room = answer->Begin(HeaderOf(MessageType::kReply, request, 0, size));
  return room.value_or(std::span<std::byte>());
}

void Channel::EndReply(std::uint64_t request, ReplySlot* later) {
  ReplySlot* const answer = later != nullptr ? later : Asked::Begun(request, *this);
  if (answer != nullptr) answer->End();
}

/// Returns false if the reply must be sent as a message.
bool Channel::Return(std::uint64_t request, std::span<const std::byte> body, ReplySlot* later) {
  ReplySlot* const answer = WayBack(request, body.size(), later);
  if (answer == nullptr) return false;
  const auto room = answer->Begin(HeaderOf(MessageType::kReply, request, 0, body.size()));
  if (!room) return false;
  std::ranges::copy(body, room->begin());
  answer->End();
  return true;
}

/// Returns false if the reply was not sent. `later` is the slot of a deferred reply.
bool Channel::SendReply(std::uint64_t request, std::span<const std::byte> body, Lane lane,
                        ReplySlot* later) {
  const bool is_alone = lane == kOwnLane;
  if (is_alone && (Return(request, body, later) || ReplyBatcher::Keep(*this, request, body))) {
    return true;
  }
  return SendReplyAlone(request, body, lane);
}

bool Channel::SendReplyAlone(std::uint64_t request, std::span<const std::byte> body, Lane lane) {
  const Status sent = Send(MessageType::kReply, request, 0, body, lane);
  if (sent || sent == Status::kNotConnected) return bool(sent);
  const Error why = WhyNotSent(sent, PeerName(), body.size());
  Log(LogLevel::kWarning, "channel", "an answer was lost: " + why.message);
  SendRefusal(request, why);
  return false;
}

/// If the link has no room for all replies, sends them one by one, because some may fit.
void Channel::SendReplies(const ReplyBatch& batch) {
  bool is_sent = false;
  if (batch.replies() > 1) {
    CallGuarded("answers", [&] {
      is_sent = Send(MessageType::kReplies, 0, 0, batch.body(), kOwnLane) == Status::kQueued;
    });
  }
  std::span<const std::byte> rest = is_sent ? std::span<const std::byte>() : batch.body();
  while (const auto one = TakeReply(rest)) {
    CallGuarded("answer", [&] { SendReplyAlone(one->request, one->answer, kOwnLane); });
  }
}

void Channel::SendRefusal(std::uint64_t request, const Error& error) {
  // If this does not fit either, the peer's request times out.
  (void)Send(MessageType::kRefusal, request, 0, EncodeBody(error));
}

}  // namespace tendon
