#include <tendon/proxy/messages.h>
#include <tendon/proxy/outbox.h>
#include <tendon/proxy/waiting/begun_calls.h>

#include <algorithm>
#include <thread>
#include <utility>
#include <vector>

namespace tendon {
namespace {

/// No more calls are added to a batch of so many bytes.
constexpr std::size_t kFullBatch = std::size_t{32} << 10U;
static_assert(kMaxPayload + kFullBatch + CallBatch::kOverhead <= kMaxBodySize,
              "the largest argument fits behind a batch that is almost full");

class QueuedCommandProxy final : public CommandBase, private Mailbox::Entry {
 public:
  QueuedCommandProxy(Outbox& outbox, const MemberDescription& command, std::uint32_t handle,
                     SharedCounter<>& refused, Mailbox& mailbox)
      : CommandBase(layout::kNone, layout::kNone),
        outbox_(outbox),
        must_wait_(WaitsForServer(command.signature.kind)),
        handle_(handle),
        refused_(refused),
        mailbox_(mailbox),
        callers_(std::make_shared<AwaitedCalls<>>(mailbox.completions())),
        pool_(mailbox.storage()) {}

  Status ExecuteEncoded(std::span<const std::byte> in, std::vector<std::byte>& /*out*/) override {
    if (must_wait_) return Status::kUnsupported;
    std::byte* room = nullptr;
    const Status claimed = Claim(in, room);
    if (claimed) {
      mailbox_.Publish(room, *this);
    } else {
      refused_.Add();
    }
    return claimed;
  }

  Status WaitEncoded(std::span<const std::byte> in, std::vector<std::byte>& out,
                     std::chrono::nanoseconds timeout) override {
    if (Channel::IsThreadOfMiddleware()) return Status::kWouldDeadlock;
    const SteadyTime deadline = DeadlineAfter(timeout);
    CompletionPool& completions = mailbox_.completions();
    const auto record = completions.Take();
    if (!record) {
      mailbox_.CountRefused();
      return Status::kQueueFull;
    }
    std::byte* room = nullptr;
    if (const Status claimed = Claim(in, room); !claimed) {
      completions[*record].Free();
      return claimed;
    }
    std::uint64_t call = 0;
    const Status entered = Host::Contain(nullptr, [&]() -> Status {  // memory may be short
      call = callers_->Enter(*record, deadline);
      return Status::kQueued;
    });
    if (!entered) {
      mailbox_.GiveUp(room);
      completions[*record].Free();
      return entered;
    }
    completions.Assign(mailbox_.SlotOf(room), *record);
    mailbox_.Publish(room, awaited_);
    return Await(*record, call, deadline, out);
  }

 private:
  /// What a slot refers to when its caller waits.
  class Awaited final : public Mailbox::Entry {
   public:
    explicit Awaited(QueuedCommandProxy& command) : command_(command) {}

    void ExecuteSlot(std::byte* /*argument*/, std::size_t slot) override {
      const auto call = command_.callers_->Start(RecordOf(slot));
      if (call) command_.Hand(*call, command_.pool_[slot]);
    }
    void DropSlot(std::size_t slot) noexcept override { command_.callers_->Drop(RecordOf(slot)); }

   private:
    [[nodiscard]] std::size_t RecordOf(std::size_t slot) const noexcept {
      return command_.mailbox_.completions().RecordOf(slot);
    }

    QueuedCommandProxy& command_;
  };

  /// kQueued, and room with the argument; or why not.
  Status Claim(std::span<const std::byte> in, std::byte*& room) {
    if (!outbox_.is_open()) return Status::kNotConnected;
    if (in.size() > kMaxPayload) {
      outbox_.RefusePayload(handle_, in.size());
      return Status::kInvalid;
    }
    room = mailbox_.Claim();
    if (room == nullptr) return mailbox_.refusal();
    const Status copied = Host::Contain(nullptr, [&]() -> Status {  // memory may be short
      pool_[mailbox_.SlotOf(room)].assign(in.begin(), in.end());
      return Status::kQueued;
    });
    if (!copied) mailbox_.GiveUp(room);
    return copied;
  }

  Status Await(std::size_t record, std::uint64_t call, SteadyTime deadline,
               std::vector<std::byte>& out) {
    using Ending = Completion<>::Ending;
    CompletionPool& completions = mailbox_.completions();
    const auto is_over = [&] { return completions.cancelled() || !outbox_.is_open(); };
    const Ending ending = completions[record].Await(is_over, deadline);
    const bool is_sent = callers_->Leave(call, ending);
    if (ending == Ending::kDone) {
      const Status status = Host::Contain(nullptr, [&] {
        if (completions[record].status()) out = callers_->answer(record);
        return completions[record].status();
      });
      completions[record].Free();
      return status;
    }
    if (ending == Ending::kStarted && is_sent) return Status::kOutcomeUnknown;
    return is_over() ? Status::kNotConnected : Status::kTimeout;
  }

  void Hand(std::uint64_t call, const Bytes& argument) {
    outbox_.Take(Outbox::Question{
        .handle = handle_, .argument = argument, .callers = callers_, .call = call});
  }

  void ExecuteSlot(std::byte* /*argument*/, std::size_t slot) override {
    outbox_.Take(handle_, pool_[slot]);
  }

  Outbox& outbox_;
  const bool must_wait_;
  const std::uint32_t handle_;
  SharedCounter<>& refused_;  // of the offer
  Mailbox& mailbox_;
  const std::shared_ptr<AwaitedCalls<>> callers_;
  Awaited awaited_{*this};
  std::vector<Bytes> pool_;  // of arguments, by slot
};

}  // namespace

Outbox::Outbox(std::shared_ptr<Channel> channel, MessageType type, Wakeup<>& wakeup,
               std::string interface)
    : channel_(std::move(channel)),
      type_(type),
      lane_(channel_->NewLane()),
      wakeup_(wakeup),
      refused_payloads_(std::move(interface)),
      inbox_(&wakeup) {
  inbox_.SetAccepting(true);
}

void Outbox::Close() {
  is_open_.Set(false);
  inbox_.SetAccepting(false);
}

void Outbox::RefusePayload(std::uint32_t handle, std::size_t size) noexcept {
  refused_payloads_.Note(handle, size);
  wakeup_.Notify();
}

std::size_t Outbox::Send(std::size_t limit) {
  const Status no_room = Status::kQueueFull;
  refused_payloads_.Tell();
  std::size_t sent = 0;
  while (true) {
    if (!is_held_up()) Collect(limit - sent);
    if (!is_held_up()) return sent;
    if (!batch_.empty()) {
      if (channel_->Notify(type_, 0, batch_.body(), lane_) == no_room) return sent;
      sent += batch_.calls();
      batch_.Clear();
    }
    if (!question_) continue;
    const Status asked = Ask(*question_);
    if (asked == no_room) return sent;
    if (asked) ++sent;
    question_.reset();
  }
}

void Outbox::SendRest(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kUntilLinkHasRoom(1);
  const SteadyTime deadline = SteadyClock().Now() + patience;
  while (is_held_up()) {
    (void)Send(batch_.calls() + (question_ ? 1 : 0));
    if (!is_held_up() || SteadyClock().Now() >= deadline) return;
    std::this_thread::sleep_for(kUntilLinkHasRoom);
  }
}

void Outbox::Collect(std::size_t limit) {
  while (!question_ && batch_.calls() < limit && batch_.body().size() < kFullBatch) {
    if (inbox_.ExecuteQueued(1) == 0) return;
  }
}

/// Its time counts from now on at the other end too, and is a little shorter there, so that what is
/// not executed in time is said in time.
Status Outbox::Ask(Question& question) {
  constexpr std::chrono::milliseconds kWayBack(20);
  const auto deadline = question.callers->Send(question.call);
  if (!deadline) return Status::kTimeout;
  const std::chrono::nanoseconds left =
      std::max(*deadline - SteadyClock().Now(), std::chrono::nanoseconds(0));
  Bytes& body = question.argument;
  const std::size_t size = body.size();
  AppendTimeout(left - std::min<std::chrono::nanoseconds>(left / 4, kWayBack), body);
  const Status asked = channel_->TryRequest(
      message::kWait, question.handle, body, std::chrono::ceil<std::chrono::milliseconds>(left),
      [callers = question.callers, call = question.call](Result<Bytes> answer) {
        callers->End(call, std::move(answer));
      },
      lane_);
  body.resize(size);
  if (!asked) question.callers->NotSent(question.call);
  return asked;
}

QueuedOfferProxy::QueuedOfferProxy(MemberDescription description, Outbox& outbox,
                                   std::uint32_t handle)
    : Offer(std::move(description)), outbox_(outbox), handle_(handle) {
  outbox_.refused_payloads().Add(handle_, this->description().name);
}

std::unique_ptr<CommandBase> QueuedOfferProxy::Bind(Mailbox* mailbox) const {
  return std::make_unique<QueuedCommandProxy>(outbox_, description(), handle_, refused_, *mailbox);
}

}  // namespace tendon
