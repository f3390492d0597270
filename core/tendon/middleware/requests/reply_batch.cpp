#include <tendon/middleware/requests/reply_batch.h>

#include <cstring>

namespace tendon {

bool ReplyBatch::Add(std::uint64_t request, std::span<const std::byte> answer) {
  const std::size_t start = body_.size();
  if (replies_ == kMostReplies || answer.size() > kMostBytes ||
      start + kOverhead + answer.size() > kMostBytes) {
    return false;
  }
  const auto size = static_cast<std::uint32_t>(answer.size());
  body_.resize(start + kOverhead + answer.size());
  std::byte* const place = body_.data() + start;
  std::memcpy(place, &request, sizeof request);
  std::memcpy(place + sizeof request, &size, sizeof size);
  if (size > 0) std::memcpy(place + kOverhead, answer.data(), size);
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
  reply.answer = body.subspan(ReplyBatch::kOverhead, size);
  body = body.subspan(ReplyBatch::kOverhead + size);
  return reply;
}

bool IsReplyBatch(std::span<const std::byte> body) {
  if (body.size() > ReplyBatch::kMostBytes) return false;
  std::size_t replies = 0;
  while (TakeReply(body)) ++replies;
  return body.empty() && replies > 0 && replies <= ReplyBatch::kMostReplies;
}

}  // namespace tendon
