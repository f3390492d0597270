#include <tendon/middleware/reply_batch.h>

#include <tendon/middleware/channel.h>
#include <tendon/middleware/pending_requests.h>

#include <cassert>
#include <cstring>
#include <utility>

namespace tendon {
namespace {

thread_local ReplyBatcher* gathered_here = nullptr;

/// The batch of this thread. It is reused, so that its capacity is kept.
ReplyBatch& BatchOfThisThread() {
  thread_local ReplyBatch batch;
  return batch;
}

}  // namespace

bool ReplyBatch::Add(std::uint64_t request, std::span<const std::byte> reply) {
  const std::size_t start = body_.size();
  if (replies_ == kMaxReplies || reply.size() > kMaxBytes ||
      start + kOverhead + reply.size() > kMaxBytes) {
    return false;
  }
  const auto size = static_cast<std::uint32_t>(reply.size());
  body_.resize(start + kOverhead + reply.size());
  std::byte* const place = body_.data() + start;
  std::memcpy(place, &request, sizeof request);
  std::memcpy(place + sizeof request, &size, sizeof size);
  if (size > 0) std::memcpy(place + kOverhead, reply.data(), size);
  ++replies_;
  return true;
}

void ReplyBatch::Clear() {
  body_.clear();
  replies_ = 0;
}

std::optional<BatchedReply> TakeReply(std::span<const std::byte>& body) {
  BatchedReply reply;
  std::uint32_t size = 0;
  static_assert(sizeof reply.request + sizeof size == ReplyBatch::kOverhead);
  if (body.size() < ReplyBatch::kOverhead) return std::nullopt;
  std::memcpy(&reply.request, body.data(), sizeof reply.request);
  std::memcpy(&size, body.data() + sizeof reply.request, sizeof size);
  if (size > body.size() - ReplyBatch::kOverhead) return std::nullopt;
  reply.body = body.subspan(ReplyBatch::kOverhead, size);
  body = body.subspan(ReplyBatch::kOverhead + size);
  return reply;
}

bool IsReplyBatch(std::span<const std::byte> body) {
  if (body.size() > ReplyBatch::kMaxBytes) return false;
  std::size_t replies = 0;
  while (TakeReply(body)) ++replies;
  return body.empty() && replies > 0 && replies <= ReplyBatch::kMaxReplies;
}

ReplyBatcher::ReplyBatcher() : batch_(BatchOfThisThread()) {
  assert(gathered_here == nullptr);
  gathered_here = this;
}

ReplyBatcher::~ReplyBatcher() {
  gathered_here = nullptr;
  if (channel_) Send();
}

bool ReplyBatcher::Keep(Channel& channel, std::uint64_t request, std::span<const std::byte> reply) {
  ReplyBatcher* const here = gathered_here;
  if (here == nullptr) return false;
  if (here->channel_ && here->channel_.get() != &channel) here->Send();
  if (!here->batch_.Add(request, reply)) {
    if (here->channel_) here->Send();
    if (!here->batch_.Add(request, reply)) return false;
  }
  if (!here->channel_) here->channel_ = channel.shared_from_this();
  return true;
}

/// Sends the collected replies. If the link has no room for all of them, sends them one by one,
/// because some may fit.
void ReplyBatcher::Send() {
  const auto channel = std::exchange(channel_, nullptr);
  bool is_sent = false;
  if (batch_.replies() > 1) {
    CallGuarded("replies", [&] {
      is_sent =
          channel->Send(MessageType::kReplies, 0, 0, batch_.body(), kOwnLane) == Status::kQueued;
    });
  }
  std::span<const std::byte> rest = is_sent ? std::span<const std::byte>() : batch_.body();
  while (const auto one = TakeReply(rest)) {
    CallGuarded("reply", [&] { channel->SendReply(one->request, one->body, kOwnLane); });
  }
  batch_.Clear();
}

}  // namespace tendon
