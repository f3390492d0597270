#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/executing_calls.h>
#include <tendon/proxy/outbox.h>

#include <algorithm>
#include <cassert>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tendon {
namespace {

/// A batch with this many bytes is full.
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
        callers_(std::make_shared<OutstandingCalls<>>(mailbox.completions())),
        pool_(mailbox.storage()) {}

  Status ExecuteEncoded(std::span<const std::byte> in, AnswerSink& /*out*/) override {
    if (must_wait_) return Status::kUnsupported;
    const Status posted = Post(in);
    if (!posted) refused_.Add();
    return posted;
  }

  Status WaitEncoded(std::span<const std::byte> in, std::vector<std::byte>& out,
                     std::chrono::nanoseconds timeout) override {
    if (Channel::IsThreadOfMiddleware()) return Status::kWouldDeadlock;
    const SteadyTime deadline = DeadlineAfter(timeout);
    if (const auto ending = WaitAtOnce(in, out, deadline)) return *ending;
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
    const Status entered = Host::Contain(nullptr, [&]() -> Status {  // may throw std::bad_alloc
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
  /// The entry for calls whose callers wait.
  class Awaited final : public Mailbox::Entry {
   public:
    explicit Awaited(QueuedCommandProxy& command) : command_(command) {}

    void ExecuteSlot(std::byte* /*argument*/, std::size_t slot) override {
      const auto call = command_.callers_->Start(RecordOf(slot));
      if (call) command_.Hand(*call, command_.pool_[slot]);
      command_.FreeIfMany(slot);
    }
    void DropSlot(std::size_t slot) noexcept override { command_.callers_->Drop(RecordOf(slot)); }

   private:
    [[nodiscard]] std::size_t RecordOf(std::size_t slot) const noexcept {
      return command_.mailbox_.completions().RecordOf(slot);
    }

    QueuedCommandProxy& command_;
  };

  /// If nothing must be sent before this call, sends it in the caller's thread without waking
  /// another thread. Otherwise returns no value, without an effect.
  std::optional<Status> WaitAtOnce(std::span<const std::byte> in, std::vector<std::byte>& out,
                                   SteadyTime deadline) {
    if (SteadyClock().Now() >= deadline) return {};
    Outbox::Turn turn = outbox_.TakeTurn();
    if (!turn || mailbox_.size() != 0 || !mailbox_.is_open() || in.size() > kMaxPayload) return {};
    const auto record = mailbox_.completions().Take();
    if (!record) return {};
    std::uint64_t call = 0;
    std::uint64_t sent = 0;
    const Status entered = Host::Contain(nullptr, [&]() -> Status {  // may throw std::bad_alloc
      Outbox::Question question = QuestionOf(0, {});
      question.argument.reserve(in.size() + sizeof(std::uint64_t));  // for the timeout
      question.argument.assign(in.begin(), in.end());
      call = question.call = callers_->Enter(*record, deadline);
      (void)callers_->Start(*record);  // succeeds: the caller is this thread
      sent = outbox_.SendNow(turn, std::move(question));
      return Status::kQueued;
    });
    turn.unlock();
    if (call == 0) {
      mailbox_.completions()[*record].Free();
      return entered;
    }
    const Status status = Await(*record, call, deadline, out);
    if (status == Status(Status::kDone)) outbox_.OnExecuted(sent, mailbox_);
    return status;
  }

  Status Post(std::span<const std::byte> in) {
    if (const Status can = Check(in); !can) return can;
    if (!outbox_.waiting_bytes().Take(in.size())) {
      mailbox_.CountRefused();
      return Status::kQueueFull;
    }
    std::byte* room = nullptr;
    const Status claimed = Claim(in, room);
    if (claimed) {
      mailbox_.Publish(room, *this);
    } else {
      outbox_.waiting_bytes().Give(in.size());
    }
    return claimed;
  }

  /// Returns kQueued, or the reason why the argument cannot be sent.
  Status Check(std::span<const std::byte> in) {
    if (!outbox_.is_open()) return Status::kNotConnected;
    if (in.size() <= kMaxPayload) return Status::kQueued;
    outbox_.RefusePayload(handle_, in.size());
    return Status::kInvalid;
  }

  /// Sets `room` and copies the argument there. Returns kQueued, or the reason of a failure.
  Status Claim(std::span<const std::byte> in, std::byte*& room) {
    if (const Status can = Check(in); !can) return can;
    room = mailbox_.Claim();
    if (room == nullptr) return mailbox_.refusal();
    const Status copied = Host::Contain(nullptr, [&]() -> Status {  // may throw std::bad_alloc
      Bytes& argument = pool_[mailbox_.SlotOf(room)];
      const std::size_t before = argument.capacity();
      argument.assign(in.begin(), in.end());
      if (argument.capacity() != before) grown_.Add(argument.capacity() - before);
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

  [[nodiscard]] Outbox::Question QuestionOf(std::uint64_t call, Bytes argument) const {
    return {.handle = handle_, .argument = std::move(argument), .callers = callers_, .call = call};
  }
  void Hand(std::uint64_t call, const Bytes& argument) { outbox_.Take(QuestionOf(call, argument)); }

  void ExecuteSlot(std::byte* /*argument*/, std::size_t slot) override {
    outbox_.waiting_bytes().Give(pool_[slot].size());
    outbox_.Take(handle_, pool_[slot]);
    FreeIfMany(slot);
  }
  void DropSlot(std::size_t slot) noexcept override {
    outbox_.waiting_bytes().Give(pool_[slot].size());
  }

  /// Frees the slot's buffer if all buffers together exceed a limit; below it, buffers are kept to
  /// save allocations.
  void FreeIfMany(std::size_t slot) noexcept {
    constexpr std::uint64_t kMostKept = std::uint64_t{64} << 20U;
    if (grown_.value() - freed_.value() <= kMostKept) return;
    freed_.Add(pool_[slot].capacity());
    Bytes().swap(pool_[slot]);
  }

  Outbox& outbox_;
  const bool must_wait_;
  const std::uint32_t handle_;
  SharedCounter<>& refused_;  // counter of the offer
  Mailbox& mailbox_;
  const std::shared_ptr<OutstandingCalls<>> callers_;
  Awaited awaited_{*this};
  SharedCounter<> grown_;    // bytes by which the buffers of the pool have grown
  SharedCounter<> freed_;    // of those, bytes freed again
  std::vector<Bytes> pool_;  // arguments, by slot; see FreeIfMany()
};

/// Works like LatestCommand: a newer call replaces an older one that waits, here or at the other
/// end. Calls whose callers wait are queued as usual.
class LatestCommandProxy final : public CommandBase, private Mailbox::Entry {
 public:
  LatestCommandProxy(Outbox& outbox, const MemberDescription& command, std::uint32_t handle,
                     SharedCounter<>& refused, Mailbox& mailbox)
      : CommandBase(layout::kNone, layout::kNone),
        outbox_(outbox),
        handle_(handle),
        refused_(refused),
        queued_(outbox, command, handle, refused, mailbox),
        newest_(mailbox) {}

  Status ExecuteEncoded(std::span<const std::byte> in, AnswerSink& /*out*/) override {
    const Status posted = Post(in);
    if (!posted) refused_.Add();
    return posted;
  }
  Status WaitEncoded(std::span<const std::byte> in, std::vector<std::byte>& out,
                     std::chrono::nanoseconds timeout) override {
    return queued_.WaitEncoded(in, out, timeout);
  }

 private:
  Status Post(std::span<const std::byte> in) {
    if (!outbox_.is_open()) return Status::kNotConnected;
    if (in.size() > kMaxPayload) {
      outbox_.RefusePayload(handle_, in.size());
      return Status::kInvalid;
    }
    return newest_.Post(*this, [&]() -> const Bytes& {  // may throw std::bad_alloc
      written_.assign(in.begin(), in.end());
      return written_;
    });
  }

  void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {
    if (const Bytes* argument = newest_.Take()) outbox_.Take(handle_, *argument);
  }
  void DropSlot(std::size_t /*slot*/) noexcept override { newest_.Take(); }

  Outbox& outbox_;
  const std::uint32_t handle_;
  SharedCounter<>& refused_;  // counter of the offer
  QueuedCommandProxy queued_;
  Bytes written_;  // used only by the posting thread
  LatestValue<Bytes> newest_;
};

}  // namespace

Outbox::Outbox(std::shared_ptr<Channel> channel, MessageType type, Wakeup<>& wakeup,
               std::string interface, const OutboxLimits& limits)
    : channel_(std::move(channel)),
      type_(type),
      lane_(channel_->NewLane()),
      wakeup_(wakeup),
      refused_payloads_(std::move(interface)),
      waiting_bytes_(limits.waiting_bytes),
      inbox_(&wakeup),
      credit_(limits.credit) {
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

void Outbox::SetExecuted(std::uint64_t calls) {
  const std::scoped_lock lock(raising_);
  if (calls > executed_.Get()) executed_.Set(calls);
}

void Outbox::OnExecuted(std::uint64_t calls, const Mailbox& callers) {
  SetExecuted(calls);
  if (callers.size() != 0) wakeup_.Notify();
}

bool Outbox::HasCallsUnderWay() const {
  const std::scoped_lock turn(sending_);
  return has_taken() || executed_.Get() < sent_;
}

std::uint64_t Outbox::Room() const {
  const std::uint64_t under_way = sent_ - std::min(executed_.Get(), sent_);
  return credit_ - std::min(under_way, credit_);
}

std::size_t Outbox::Send(std::size_t limit) {
  refused_payloads_.Tell();
  const Turn turn(sending_, std::try_to_lock);
  has_waited_ = !turn;
  if (!turn) return 0;
  if (executed_.Get() > sent_) {
    channel_->CutOff("acknowledged that " + std::to_string(executed_.Get()) +
                     " calls were executed, but only " + std::to_string(sent_) +
                     " were sent to it");
    return 0;
  }
  return SendTaken(std::min(limit, Room()), &Channel::TryRequest);
}

Outbox::Turn Outbox::TakeTurn() {
  Turn turn(sending_, std::try_to_lock);
  if (turn && (!is_open() || has_taken() || Room() == 0)) turn.unlock();
  return turn;
}

std::uint64_t Outbox::SendNow([[maybe_unused]] const Turn& turn, Question question) {
  assert(turn.mutex() == &sending_ && turn.owns_lock() && !has_taken());
  question_ = std::move(question);
  SendTaken(1, &Channel::TryAsk);
  if (!has_taken()) return sent_;
  wakeup_.Notify();
  return 0;
}

/// Sends the calls already taken, then those in the inbox, up to `limit`. Counts each call as it is
/// sent.
std::size_t Outbox::SendTaken(std::size_t limit, Manner manner) {
  const Status no_room = Status::kQueueFull;
  const std::uint64_t before = sent_;
  while (true) {
    const std::uint64_t sent = sent_ - before;
    if (!has_taken() && sent < limit) Collect(limit - sent);
    if (!has_taken()) return sent;
    if (!batch_.empty()) {
      if (channel_->Notify(type_, 0, batch_.body(), lane_) == no_room) return sent;
      sent_ += batch_.calls();
      batch_.Clear();
    }
    if (!question_) continue;
    const Status asked = Ask(*question_, manner);
    if (asked == no_room) return sent_ - before;
    if (asked) ++sent_;
    question_.reset();
  }
}

void Outbox::SendRest(std::chrono::milliseconds patience) {
  constexpr std::chrono::milliseconds kUntilLinkHasRoom(1);
  const SteadyTime deadline = SteadyClock().Now() + patience;
  while (is_held_up()) {
    (void)Send(0);
    if (!is_held_up() || SteadyClock().Now() >= deadline) return;
    std::this_thread::sleep_for(kUntilLinkHasRoom);
  }
}

void Outbox::Collect(std::size_t limit) {
  while (!question_ && batch_.calls() < limit && batch_.body().size() < kFullBatch) {
    if (inbox_.ExecuteQueued(1) == 0) return;
  }
}

/// The timeout at the other end starts now and is a little shorter, so that its report arrives
/// before the caller's own timeout.
Status Outbox::Ask(Question& question, Manner manner) {
  constexpr std::chrono::milliseconds kWayBack(20);
  const SteadyTime now = SteadyClock().Now();
  const auto deadline = question.callers->Send(question.call, now);
  if (!deadline) return Status::kTimeout;
  const std::chrono::nanoseconds left = *deadline - now;
  Bytes& body = question.argument;
  const std::size_t size = body.size();
  AppendTimeout(left - std::min<std::chrono::nanoseconds>(left / 4, kWayBack), body);
  const Status asked = ((*channel_).*manner)(
      message::kWait, question.handle, body, std::chrono::ceil<std::chrono::milliseconds>(left),
      [callers = question.callers, call = question.call](Result<Bytes> answer) {
        callers->End(call, std::move(answer));
      },
      lane_);
  body.resize(size);
  if (asked == Status(Status::kQueueFull)) {
    question.callers->NotSent(question.call);
  } else if (!asked) {
    question.callers->Refuse(question.call, asked);
  }
  return asked;
}

Overflow OverflowOf(const std::vector<std::string>& latest_only, const std::string& member) {
  const bool is_one = std::ranges::find(latest_only, member) != latest_only.end();
  return is_one ? Overflow::kLatestOnly : Overflow::kRefuse;
}

QueuedOfferProxy::QueuedOfferProxy(MemberDescription description, Outbox& outbox,
                                   std::uint32_t handle)
    : Offer(std::move(description)), outbox_(outbox), handle_(handle) {
  outbox_.refused_payloads().Add(handle_, this->description().name);
}

Mailbox::SlotShape QueuedOfferProxy::shape() const {
  constexpr std::size_t kTokens = 2;  // most tokens of a LatestCommand
  return {.reserve = keeps_latest_only() ? kTokens : 0};
}

std::unique_ptr<CommandBase> QueuedOfferProxy::Bind(Mailbox* mailbox) const {
  if (keeps_latest_only()) {
    return std::make_unique<LatestCommandProxy>(outbox_, description(), handle_, refused_,
                                                *mailbox);
  }
  return std::make_unique<QueuedCommandProxy>(outbox_, description(), handle_, refused_, *mailbox);
}

}  // namespace tendon
