#include <tendon/proxy/queued_offer_proxy.h>

#include <tendon/base/clock.h>
#include <tendon/interface/command.h>
#include <tendon/interface/execution/blocking_call_entry.h>
#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/execution/latest_value.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tendon {
namespace {

/// Returns kQueued if an argument of `size` bytes can be sent, otherwise the reason why not.
Status CheckPayload(Outbox& outbox, std::uint32_t handle, std::size_t size) {
  if (!outbox.is_open()) return Status::kNotConnected;
  if (size <= kMaxPayload) return Status::kQueued;
  outbox.RefusePayload(handle, size);
  return Status::kInvalid;
}

/// A buffer for each slot of a mailbox. Buffers are kept, to save allocations, while all of them
/// together are small. Each buffer is used by one thread at a time.
class SlotBuffers {
 public:
  /// Keeps buffers while all of them have at most `most_kept` bytes.
  SlotBuffers(std::size_t slots, std::uint64_t most_kept)
      : buffers_(slots), most_kept_(most_kept) {}

  CallBuffer& operator[](std::size_t slot) { return buffers_[slot]; }
  /// Returns the memory for an argument of `size` bytes in the buffer of a slot.
  std::span<std::byte> Resize(std::size_t slot, std::size_t size) {
    CallBuffer& buffer = buffers_[slot];
    const std::size_t before = buffer.capacity();
    const std::span<std::byte> argument = buffer.Resize(size);
    if (buffer.capacity() != before) grown_.Add(buffer.capacity() - before);
    return argument;
  }
  /// Must be called after the last use of a buffer. Frees it if all buffers together are too large.
  void FreeIfMany(std::size_t slot) noexcept {
    // Read before grown_, so that the difference is never below zero.
    const std::uint64_t freed = freed_.value();
    if (grown_.value() - freed <= most_kept_) return;
    freed_.Add(buffers_[slot].capacity());
    buffers_[slot] = {};
  }

 private:
  std::vector<CallBuffer> buffers_;
  const std::uint64_t most_kept_;
  SharedCounter<> grown_;  // bytes by which the buffers have grown
  SharedCounter<> freed_;  // the part of these bytes that was freed again
};

class QueuedCommandProxy : public CommandBase, protected Mailbox::Entry {
 public:
  QueuedCommandProxy(Outbox& outbox, const MemberDescription& command, std::uint32_t handle,
                     SharedCounter<>& refused, Mailbox& mailbox)
      : CommandBase(layout::kNone, layout::kNone),
        outbox_(outbox),
        handle_(handle),
        refused_(refused),
        mailbox_(mailbox),
        must_wait_(WaitsForServer(command.signature.kind)),
        callers_(std::make_shared<OutstandingCalls<>>(mailbox.completions())),
        arguments_(mailbox.storage(), std::uint64_t{64} << 20U) {}

  Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& out) override {
    return ExecuteFrom(EncodedArgument(in), out);
  }
  Status ExecuteFrom(const ArgumentWriter& in, ReplySink& /*out*/) override {
    if (must_wait_) return Status::kUnsupported;
    const Status posted = Post(in);
    if (!posted) refused_.Add();
    return posted;
  }

  Status WaitEncoded(std::span<const std::byte> in, std::vector<std::byte>& out,
                     std::chrono::nanoseconds timeout) override {
    if (Channel::IsThreadOfMiddleware()) return Status::kWouldDeadlock;
    if (const Status can = CheckPayload(outbox_, handle_, in.size()); !can) return can;
    const SteadyTime deadline = DeadlineAfter(timeout);
    if (const auto ending = WaitAtOnce(in, out, deadline)) return *ending;
    CompletionPool& completions = mailbox_.completions();
    const auto record = completions.Take();
    if (!record) {
      mailbox_.CountRefused();
      return Status::kQueueFull;
    }
    std::byte* room = nullptr;
    if (const Status claimed = Claim(EncodedArgument(in), in.size(), room); !claimed) {
      completions[*record].Free();
      return claimed;
    }
    std::uint64_t call = 0;
    const Status entered =
        ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {  // may throw bad_alloc
          call = callers_->Enter(*record, deadline);
          return Status::kQueued;
        });
    if (!entered) {
      mailbox_.GiveUp(room);
      completions[*record].Free();
      return entered;
    }
    completions.Assign(mailbox_.SlotOf(room), *record);
    mailbox_.Publish(room, blocking_entry_);
    return Await(*record, call, deadline, out);
  }

 protected:
  Outbox& outbox_;
  const std::uint32_t handle_;
  SharedCounter<>& refused_;  // the counter of the offer
  Mailbox& mailbox_;

 private:
  friend class BlockingCallEntry<QueuedCommandProxy>;

  /// Sends the call in the caller's thread and waits for the reply, so that no other thread must
  /// be woken. Returns nothing, and changes nothing, if other calls must be sent first.
  std::optional<Status> WaitAtOnce(std::span<const std::byte> in, std::vector<std::byte>& out,
                                   SteadyTime deadline) {
    if (SteadyClock().Now() >= deadline) return {};
    Outbox::Turn turn = outbox_.TakeTurn();
    if (!turn || mailbox_.size() != 0 || !mailbox_.is_open()) return {};
    const auto record = mailbox_.completions().Take();
    if (!record) return {};
    std::uint64_t call = 0;
    std::uint64_t sent = 0;
    const Status entered =
        ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {  // may throw bad_alloc
          Outbox::BlockingCall blocking_call = BlockingCallOf(0, {});
          blocking_call.argument.reserve(in.size() + sizeof(std::uint64_t));  // for the timeout
          blocking_call.argument.assign(in.begin(), in.end());
          call = blocking_call.number = callers_->Enter(*record, deadline);
          (void)callers_->Start(*record);  // succeeds: the caller is this thread
          sent = outbox_.SendNow(turn, std::move(blocking_call));
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

  Status Post(const ArgumentWriter& in) {
    const std::size_t size = in.size();
    if (const Status can = CheckPayload(outbox_, handle_, size); !can) return can;
    if (!outbox_.waiting_bytes().Take(size)) {
      mailbox_.CountRefused();
      return Status::kQueueFull;
    }
    std::byte* room = nullptr;
    const Status claimed = Claim(in, size, room);
    if (claimed) {
      mailbox_.Publish(room, *this);
    } else {
      outbox_.waiting_bytes().Give(size);
    }
    return claimed;
  }

  /// Claims a slot of the mailbox, sets `room` to it, and writes the argument into the slot's
  /// buffer. Returns kQueued, or the reason why the claim failed; kFailed if the codec threw an
  /// exception.
  Status Claim(const ArgumentWriter& in, std::size_t size, std::byte*& room) {
    room = mailbox_.Claim();
    if (room == nullptr) return outbox_.is_open() ? mailbox_.refusal() : Status::kNotConnected;
    const std::size_t slot = mailbox_.SlotOf(room);
    const Status written =
        ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {  // may throw bad_alloc
          return in.WriteTo(arguments_.Resize(slot, size)) ? Status::kQueued : Status::kFailed;
        });
    if (!written) {
      arguments_.FreeIfMany(slot);
      mailbox_.GiveUp(room);
    }
    return written;
  }

  Status Await(std::size_t record, std::uint64_t call, SteadyTime deadline,
               std::vector<std::byte>& out) {
    using Ending = Completion<>::Ending;
    CompletionPool& completions = mailbox_.completions();
    const auto is_over = [&] { return completions.cancelled() || !outbox_.is_open(); };
    const Ending ending = completions[record].Await(is_over, deadline);
    const bool is_sent = callers_->Leave(call, ending);
    if (ending == Ending::kDone) {
      const Status status = ComponentAccess::CatchExceptions(nullptr, [&] {
        if (completions[record].status()) out = callers_->reply(record);
        return completions[record].status();
      });
      completions[record].Free();
      return status;
    }
    if (ending == Ending::kStarted && is_sent) return Status::kOutcomeUnknown;
    return is_over() ? Status::kNotConnected : Status::kTimeout;
  }

  [[nodiscard]] Outbox::BlockingCall BlockingCallOf(std::uint64_t call, Bytes argument) const {
    return {
        .handle = handle_, .argument = std::move(argument), .callers = callers_, .number = call};
  }
  void ExecuteSlot(std::byte* /*argument*/, std::size_t slot) override {
    outbox_.waiting_bytes().Give(arguments_[slot].argument().size());
    outbox_.SendOrBatch(handle_, arguments_[slot], mailbox_);
    arguments_.FreeIfMany(slot);
  }
  void DropSlot(std::byte* /*argument*/, std::size_t slot) noexcept override {
    outbox_.waiting_bytes().Give(arguments_[slot].argument().size());
  }

  void ExecuteBlockingCall(std::byte* /*argument*/, std::size_t slot) {
    if (const auto call = callers_->Start(mailbox_.completions().RecordOf(slot))) {
      const std::span<const std::byte> argument = arguments_[slot].argument();
      outbox_.SetBlockingCall(BlockingCallOf(*call, Bytes(argument.begin(), argument.end())));
    }
    arguments_.FreeIfMany(slot);
  }
  void DropBlockingCall(std::byte* /*argument*/, std::size_t slot) noexcept {
    callers_->Drop(mailbox_.completions().RecordOf(slot));
  }

  const bool must_wait_;
  const std::shared_ptr<OutstandingCalls<>> callers_;
  BlockingCallEntry<QueuedCommandProxy> blocking_entry_{*this};
  SlotBuffers arguments_;  // 64 MiB at most are kept
};

/// Behaves like LatestCommand: a newer call replaces an older one that is still queued, here or in
/// the other process. Calls whose callers wait are queued as in a QueuedCommandProxy.
class LatestCommandProxy final : public QueuedCommandProxy {
 public:
  LatestCommandProxy(Outbox& outbox, const MemberDescription& command, std::uint32_t handle,
                     SharedCounter<>& refused, Mailbox& mailbox)
      : QueuedCommandProxy(outbox, command, handle, refused, mailbox), newest_(mailbox) {}

  Status ExecuteFrom(const ArgumentWriter& in, ReplySink& /*out*/) override {
    const Status posted = Post(in);
    if (!posted) refused_.Add();
    return posted;
  }

 private:
  Status Post(const ArgumentWriter& in) {
    const std::size_t size = in.size();
    if (const Status can = CheckPayload(outbox_, handle_, size); !can) return can;
    return newest_.Post(*this, [&](CallBuffer& call) {  // may throw bad_alloc
      if (!in.WriteTo(call.Resize(size))) throw std::length_error("the argument has changed");
    });
  }

  void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {
    if (CallBuffer* const call = newest_.Take()) outbox_.SendOrBatch(handle_, *call, mailbox_);
  }
  void DropSlot(std::byte* /*argument*/, std::size_t /*slot*/) noexcept override { newest_.Take(); }

  LatestValue<CallBuffer> newest_;
};

/// Sends observed calls. The slot itself holds a call of usual size, because the thread that
/// executed the call must not allocate. Larger calls have a buffer for each slot; these are kept
/// while all of them together are small.
class ObservedCallProxy final : public CommandBase, private Mailbox::Entry {
 public:
  static constexpr std::size_t kRoom = 240;

  ObservedCallProxy(Outbox& outbox, std::uint32_t handle, SharedCounter<>& lost, Mailbox& mailbox)
      : CommandBase(layout::kNone, layout::kNone),
        outbox_(outbox),
        handle_(handle),
        lost_(lost),
        mailbox_(mailbox),
        large_(mailbox.storage(), std::uint64_t{1} << 20U) {}  // there may be hundreds of observers

  static constexpr Mailbox::SlotShape Shape() { return {sizeof(Slot), alignof(Slot)}; }

  Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& out) override {
    return ExecuteFrom(EncodedArgument(in), out);
  }
  Status ExecuteFrom(const ArgumentWriter& in, ReplySink& /*out*/) override {
    // The codec may throw.
    const Status posted = ComponentAccess::CatchExceptions(nullptr, [&] { return Post(in); });
    if (!posted) lost_.Add();
    return posted;
  }

 private:
  struct Slot {
    std::size_t size = 0;
    std::array<std::byte, kRoom> call;
  };

  Status Post(const ArgumentWriter& in) {
    const std::size_t size = in.size();
    if (const Status can = CheckPayload(outbox_, handle_, size); !can) return can;
    if (!outbox_.waiting_bytes().Take(size)) return Status::kQueueFull;
    std::byte* const room = mailbox_.ClaimAtOnce();  // a component never waits for an observer
    const Status written = room == nullptr ? mailbox_.refusal() : Write(in, size, room);
    if (written) {
      mailbox_.Publish(room, *this);
      return written;
    }
    if (room != nullptr) {
      large_.FreeIfMany(mailbox_.SlotOf(room));
      mailbox_.GiveUp(room);
    }
    outbox_.waiting_bytes().Give(size);
    return written;
  }
  Status Write(const ArgumentWriter& in, std::size_t size, std::byte* room) {
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {  // may throw bad_alloc
      auto* const slot = new (room) Slot;
      slot->size = size;
      const bool is_large = size > kRoom;
      const std::span<std::byte> place =
          is_large ? large_.Resize(mailbox_.SlotOf(room), size) : std::span(slot->call).first(size);
      return in.WriteTo(place) ? Status::kQueued : Status::kFailed;
    });
  }
  static Slot& SlotIn(std::byte* argument) {
    return *std::launder(reinterpret_cast<Slot*>(argument));
  }

  void ExecuteSlot(std::byte* argument, std::size_t slot) override {
    const Slot& here = SlotIn(argument);
    outbox_.waiting_bytes().Give(here.size);
    if (here.size > kRoom) {
      outbox_.SendOrBatch(handle_, large_[slot], mailbox_);
    } else {
      outbox_.AddToBatch(handle_, std::span(here.call).first(here.size));
    }
    large_.FreeIfMany(slot);
  }
  void DropSlot(std::byte* argument, std::size_t /*slot*/) noexcept override {
    outbox_.waiting_bytes().Give(SlotIn(argument).size);
  }

  Outbox& outbox_;
  const std::uint32_t handle_;
  SharedCounter<>& lost_;  // of the offer
  Mailbox& mailbox_;
  SlotBuffers large_;
};

}  // namespace

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
  if (observes_calls_) return ObservedCallProxy::Shape();
  constexpr std::size_t kTokens = 2;  // the most tokens that a LatestCommand posts
  return {.reserve = keeps_latest_only() ? kTokens : 0};
}

std::unique_ptr<CommandBase> QueuedOfferProxy::Bind(Mailbox* mailbox) const {
  if (observes_calls_) {
    return std::make_unique<ObservedCallProxy>(outbox_, handle_, refused_, *mailbox);
  }
  if (keeps_latest_only()) {
    return std::make_unique<LatestCommandProxy>(outbox_, description(), handle_, refused_,
                                                *mailbox);
  }
  return std::make_unique<QueuedCommandProxy>(outbox_, description(), handle_, refused_, *mailbox);
}

}  // namespace tendon
