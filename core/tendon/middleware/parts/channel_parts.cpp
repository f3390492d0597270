#include <tendon/middleware/channel.h>
#include <tendon/middleware/parts/large_message_in_progress.h>
#include <tendon/middleware/parts/progress_sender.h>

#include <algorithm>
#include <utility>

namespace tendon {

void Channel::OnPart(const FrameHeader& header, std::span<const std::byte> part) {
  using Progress = PartAssembly::Progress;
  PartAssembly::Frame frame;
  const Progress progress = assembly_.Add(header.handle, part, frame);
  taken_.Set(assembly_.taken());
  given_up_.Set(assembly_.given_up());
  last_part_.Set(SteadyClock().Now());
  switch (progress) {
    case Progress::kMoreToCome:
      return;
    case Progress::kNonsense:
      return Fail({ErrorCode::kInvalid, peer_.name + " sent parts that are not a valid message"});
    case Progress::kOutOfMemory:
      return OnNoRoom("out of memory (ulimit -v)", FrameHeader::kSize + frame.header.size);
    case Progress::kTooMuch:
      return OnTooMuch(frame.header);
    case Progress::kWhole:
      break;
  }
  TellTaken();
  HandleLarge(std::move(frame));
}

/// Refuses a request. A notice has no answer, so the link ends; otherwise the notice would be lost
/// silently.
void Channel::OnTooMuch(const FrameHeader& header) {
  constexpr const char* kWhy = "512 MiB of unfinished messages are already kept";
  if (header.request == 0) return OnNoRoom(kWhy, FrameHeader::kSize + header.size);
  CallGuarded(peer_.name, [&] { SendRefusal(header.request, {ErrorCode::kFailed, kWhy}); });
}

/// Called before any part of a large frame is stored, so that a peer need not send 64 MiB to be
/// refused.
bool Channel::IsWanted(const FrameHeader& header) {
  if (header.type == MessageType::kReply || header.type == MessageType::kRefusal) {
    return requests_.IsAwaited(header.request);
  }
  std::optional<Error> refusal = Error{ErrorCode::kFailed, "the required role is unknown"};
  CallGuarded(peer_.name, [&] { refusal = handler_->WhyNotTaken(*this, header); });
  if (refusal && header.request != 0) SendRefusal(header.request, *refusal);
  return !refusal;
}

/// The peer may pause between parts while it handles a large message, and this end does not read
/// parts while it handles one.
bool Channel::IsUnfinishedTooLong(SteadyTime now) const {
  return now >=
         std::max(given_up_.Get(), LargeMessageInProgress::Last(now) + PartAssembly::kPatience);
}

/// Handling may take long, and this thread does not read meanwhile. So a ProgressSender repeatedly
/// sends the number of received bytes to the peer. A reply is moved to its requester, not copied.
void Channel::HandleLarge(PartAssembly::Frame frame) {
  std::optional<LargeMessageInProgress> mark;
  std::optional<ProgressSender> sign;
  if (frame.body.size() >= LargeMessageInProgress::kLeast) {
    mark.emplace();
    sign.emplace(peer_.name, [this] { SendTaken(); });
  }
  const FrameHeader& header = frame.header;
  if (header.type != MessageType::kReply) return OnMessage(header, frame.body);
  if (HasOurVersion(header)) requests_.OnAnswer(header.request, Answer(std::move(frame.body)));
}

void Channel::OnPartsTaken(std::span<const std::byte> body) {
  const auto taken = DecodeBody<std::uint64_t>(body);
  last_part_.Set(SteadyClock().Now());
  if (taken && parts_.OnTaken(*link_, *taken)) return;
  Fail({ErrorCode::kInvalid, peer_.name + " acknowledged more than was sent to it"});
}

void Channel::TellTaken() {
  if (taken_.Get() != told_taken_.Get()) SendTaken();
}

void Channel::SendTaken() {
  const std::scoped_lock lock(telling_);  // keeps the numbers in order
  const std::uint64_t taken = taken_.Get();
  const Bytes body = EncodeBody(taken);
  const FrameHeader header = HeaderOf(MessageType::kPartsTaken, 0, 0, body.size());
  if (SendPiece(header, body)) told_taken_.Set(taken);
}

/// Called after each send and arrival, and regularly, because the link may have room again.
void Channel::Resume() {
  TellTaken();
  parts_.Resume(*link_);
}

}  // namespace tendon
