#include <tendon/middleware/responder.h>

#include <tendon/middleware/channel.h>
#include <tendon/middleware/pending_requests.h>
#include <tendon/middleware/reply_batch.h>

#include <algorithm>
#include <cassert>
#include <utility>

namespace tendon {
namespace {

thread_local const CurrentRequest* current_request = nullptr;

}  // namespace

CurrentRequest::CurrentRequest(const Channel& channel, std::uint64_t request, ReplySlot& slot)
    : channel_(channel), request_(request), slot_(slot) {
  assert(current_request == nullptr);
  current_request = this;
}

CurrentRequest::~CurrentRequest() { current_request = nullptr; }

ReplySlot* CurrentRequest::SlotOf(const Channel& channel, std::uint64_t request) {
  const CurrentRequest* const here = current_request;
  const bool is_it = here != nullptr && &here->channel_ == &channel && here->request_ == request;
  return is_it ? &here->slot_ : nullptr;
}

Responder::Responder(std::weak_ptr<Channel> channel, std::uint64_t request)
    : channel_(std::move(channel)), request_(request) {}

Responder& Responder::operator=(Responder&& other) noexcept {
  std::swap(channel_, other.channel_);
  std::swap(request_, other.request_);
  std::swap(later_, other.later_);
  return *this;
}

Responder::~Responder() {
  if (channel_.expired()) return;
  CallGuarded("request", [this] {
    Refuse({ErrorCode::kFailed, "the request was dropped without a reply; see the peer's log"});
  });
}

bool Responder::TryReply(std::span<const std::byte> body, Lane lane) {
  const auto channel = channel_.lock();
  if (!channel) return false;
  const bool is_alone = lane == kOwnLane;
  const bool is_sent =
      (is_alone && (ReplyInSlot(*channel, body) || ReplyBatcher::Keep(*channel, request_, body))) ||
      channel->SendReply(request_, body, lane);
  channel_.reset();  // if sending throws, the channel stays set, and the destructor refuses
  return is_sent;
}

/// Returns the slot to which this thread may write the reply; null if the reply must be sent as a
/// message.
ReplySlot* Responder::EmptySlot(const Channel& channel) const {
  ReplySlot* const slot = CurrentRequest::SlotOf(channel, request_);
  return slot != nullptr && !slot->has_begun() ? slot : nullptr;
}

/// Returns the slot for a reply of `size` bytes: the slot of a deferred reply, or the slot of the
/// request that this thread handles. Returns null if the reply must be sent as a message.
ReplySlot* Responder::SlotFor(Channel& channel, std::size_t size) const {
  ReplySlot* const slot = later_ != nullptr ? later_.get() : EmptySlot(channel);
  return slot != nullptr && channel.FitsInSlot(FrameHeader::kSize + size) ? slot : nullptr;
}

/// Writes the reply to a slot. Returns false if the reply must be sent as a message.
bool Responder::ReplyInSlot(Channel& channel, std::span<const std::byte> body) {
  ReplySlot* const slot = SlotFor(channel, body.size());
  if (slot == nullptr) return false;
  const auto room = slot->Begin(Channel::HeaderOf(MessageType::kReply, request_, 0, body.size()));
  if (!room) return false;
  std::ranges::copy(body, room->begin());
  slot->End();
  return true;
}

std::span<std::byte> Responder::BeginReply(std::size_t size) {
  const auto channel = channel_.lock();
  ReplySlot* const slot = channel ? SlotFor(*channel, size) : nullptr;
  if (slot == nullptr) return {};
  const auto room = slot->Begin(Channel::HeaderOf(MessageType::kReply, request_, 0, size));
  return room.value_or(std::span<std::byte>());
}

void Responder::EndReply() {
  const auto channel = std::exchange(channel_, {}).lock();
  if (!channel) return;
  ReplySlot* const slot =
      later_ != nullptr ? later_.get() : CurrentRequest::SlotOf(*channel, request_);
  if (slot != nullptr && slot->has_begun()) slot->End();
}

bool Responder::Defer() {
  const auto channel = channel_.lock();
  ReplySlot* const slot = channel ? EmptySlot(*channel) : nullptr;
  if (slot != nullptr) later_ = slot->Defer();
  return later_ != nullptr;
}

void Responder::Refuse(const Error& error) {
  if (const auto channel = std::exchange(channel_, {}).lock()) {
    channel->SendRefusal(request_, error);
  }
}

void Responder::ReplyWith(const Result<void>& result) {
  if (result) {
    Reply(EncodeBody(None{}));
  } else {
    Refuse(result.error());
  }
}

}  // namespace tendon
