#include <tendon/proxy/outbox.h>

#include <utility>
#include <vector>

namespace tendon {
namespace {

/// No more calls are added to a batch of so many bytes.
constexpr std::size_t kFullBatch = std::size_t{32} << 10U;
/// Of one argument, so that it fits behind a batch that is almost full.
constexpr std::size_t kMostBytes =
    kMaxFrameSize - FrameHeader::kSize - kFullBatch - CallBatch::kOverhead;

class QueuedCommandProxy final : public CommandBase, private Mailbox::Entry {
 public:
  QueuedCommandProxy(Outbox& outbox, std::uint32_t handle, Mailbox& mailbox)
      : CommandBase(layout::kNone, layout::kNone),
        outbox_(outbox),
        handle_(handle),
        mailbox_(mailbox),
        pool_(mailbox.storage()) {}

  Status ExecuteEncoded(std::span<const std::byte> in, std::vector<std::byte>& /*out*/) override {
    if (!outbox_.is_open()) return Status::kNotConnected;
    if (in.size() > kMostBytes) return Status::kInvalid;
    std::byte* const room = mailbox_.Claim();
    if (room == nullptr) return mailbox_.refusal();
    pool_[mailbox_.SlotOf(room)].assign(in.begin(), in.end());
    mailbox_.Publish(room, *this);
    return Status::kQueued;
  }

 private:
  void ExecuteSlot(std::byte* /*argument*/, std::size_t slot) override {
    outbox_.Take(handle_, pool_[slot]);
  }

  Outbox& outbox_;
  const std::uint32_t handle_;
  Mailbox& mailbox_;
  std::vector<Bytes> pool_;
};

}  // namespace

Outbox::Outbox(std::shared_ptr<Channel> channel, MessageType type, Wakeup<>& wakeup)
    : channel_(std::move(channel)), type_(type), inbox_(&wakeup) {
  inbox_.SetAccepting(true);
}

std::size_t Outbox::Send(std::size_t limit) {
  std::size_t sent = 0;
  while (true) {
    if (batch_.empty()) Collect(limit - sent);
    if (batch_.empty()) return sent;
    if (channel_->Notify(type_, 0, batch_.body()) == Status(Status::kQueueFull)) return sent;
    sent += batch_.calls();
    batch_.Clear();
  }
}

void Outbox::Collect(std::size_t limit) {
  while (batch_.calls() < limit && batch_.body().size() < kFullBatch) {
    if (inbox_.ExecuteQueued(1) == 0) return;
  }
}

std::unique_ptr<CommandBase> QueuedOfferProxy::Bind(Mailbox* mailbox) const {
  return std::make_unique<QueuedCommandProxy>(outbox_, handle_, *mailbox);
}

}  // namespace tendon
