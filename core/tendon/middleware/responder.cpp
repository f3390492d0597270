#include <tendon/middleware/channel.h>
#include <tendon/middleware/pending_requests.h>
#include <tendon/middleware/responder.h>

#include <utility>

namespace tendon {

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
    Refuse({ErrorCode::kFailed, "the request was dropped without an answer; see the peer's log"});
  });
}

bool Responder::TryReply(std::span<const std::byte> body, Lane lane) {
  const auto channel = channel_.lock();
  if (!channel) return false;
  const bool is_sent = channel->SendReply(request_, body, lane, later_.get());
  channel_.reset();  // not if TryReply() throws: then the destructor refuses
  return is_sent;
}

std::span<std::byte> Responder::BeginReply(std::size_t size) {
  const auto channel = channel_.lock();
  return channel ? channel->BeginReply(request_, size, later_.get()) : std::span<std::byte>();
}

void Responder::EndReply() {
  const auto channel = std::exchange(channel_, {}).lock();
  if (channel) channel->EndReply(request_, later_.get());
}

bool Responder::Defer() {
  const auto channel = channel_.lock();
  ReplySlot* const answer = channel ? channel->EmptySlotOf(request_) : nullptr;
  if (answer != nullptr) later_ = answer->Defer();
  return later_ != nullptr;
}

void Responder::Refuse(const Error& error) {
  if (const auto channel = std::exchange(channel_, {}).lock()) {
    channel->SendRefusal(request_, error);
  }
}

void Responder::Answer(const Result<void>& result) {
  if (result) {
    Reply(EncodeBody(None{}));
  } else {
    Refuse(result.error());
  }
}

}  // namespace tendon
