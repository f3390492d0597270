#include <tendon/middleware/channel.h>
#include <tendon/middleware/requests/gathered_replies.h>

#include <cassert>
#include <utility>

namespace tendon {
namespace {

thread_local GatheredReplies* gathered_here = nullptr;

/// Keeps its capacity.
ReplyBatch& BatchOfThisThread() {
  thread_local ReplyBatch batch;
  return batch;
}

}  // namespace

GatheredReplies::GatheredReplies() : batch_(BatchOfThisThread()) {
  assert(gathered_here == nullptr);
  gathered_here = this;
}

GatheredReplies::~GatheredReplies() {
  gathered_here = nullptr;
  if (channel_) Send();
}

bool GatheredReplies::Keep(Channel& channel, std::uint64_t request,
                           std::span<const std::byte> answer) {
  GatheredReplies* const here = gathered_here;
  if (here == nullptr) return false;
  if (here->channel_ && here->channel_.get() != &channel) here->Send();
  if (!here->batch_.Add(request, answer)) {
    if (here->channel_) here->Send();
    if (!here->batch_.Add(request, answer)) return false;
  }
  if (!here->channel_) here->channel_ = channel.shared_from_this();
  return true;
}

void GatheredReplies::Send() {
  const auto channel = std::exchange(channel_, nullptr);
  channel->SendReplies(batch_);
  batch_.Clear();
}

}  // namespace tendon
