#include <tendon/middleware/channel.h>
#include <tendon/middleware/requests/reply_batcher.h>

#include <cassert>
#include <utility>

namespace tendon {
namespace {

thread_local ReplyBatcher* gathered_here = nullptr;

/// Keeps its capacity.
ReplyBatch& BatchOfThisThread() {
  thread_local ReplyBatch batch;
  return batch;
}

}  // namespace

ReplyBatcher::ReplyBatcher() : batch_(BatchOfThisThread()) {
  assert(gathered_here == nullptr);
  gathered_here = this;
}

ReplyBatcher::~ReplyBatcher() {
  gathered_here = nullptr;
  if (channel_) Send();
}

bool ReplyBatcher::Keep(Channel& channel, std::uint64_t request,
                        std::span<const std::byte> answer) {
  ReplyBatcher* const here = gathered_here;
  if (here == nullptr) return false;
  if (here->channel_ && here->channel_.get() != &channel) here->Send();
  if (!here->batch_.Add(request, answer)) {
    if (here->channel_) here->Send();
    if (!here->batch_.Add(request, answer)) return false;
  }
  if (!here->channel_) here->channel_ = channel.shared_from_this();
  return true;
}

void ReplyBatcher::Send() {
  const auto channel = std::exchange(channel_, nullptr);
  channel->SendReplies(batch_);
  batch_.Clear();
}

}  // namespace tendon
