#pragma once

#include <tendon/base/clock.h>
#include <tendon/interface/command.h>
#include <tendon/interface/execution/blocking_call_entry.h>
#include <tendon/interface/execution/call_observer.h>
#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/execution/expiry.h>
#include <tendon/interface/mailbox.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

namespace tendon {

/// True for types that are stored directly in a mailbox slot. Values of other types are assigned to
/// pooled objects, which keep their memory.
template <typename T>
inline constexpr bool kLiesInSlot = std::is_trivially_copyable_v<T>;

/// Queues each call in the mailbox. The thread that empties the mailbox runs `handler(in, out)`. A
/// component without a thread has no mailbox; then the caller's thread runs `handler`, if
/// `component` accepts calls.
///
/// A caller gets the result only if it waits. Results are stored in a pool, because the caller may
/// stop waiting before its call ends.
template <Payload In, Payload Out, typename Handler>
class QueuedCommand final : public Command<In, Out>, private Mailbox::Entry {
 public:
  static_assert(alignof(In) <= 64, "an argument of a queued command is aligned to at most 64");

  /// Each executed call renews `expiry`, which may be null. Observers of `offer`, which may be
  /// null, see each call.
  QueuedCommand(Handler handler, Mailbox* mailbox, const ComponentAccess* component = nullptr,
                Expiry* expiry = nullptr, const CallSwitches* offer = nullptr)
      : handler_(std::move(handler)),
        mailbox_(mailbox),
        component_(component),
        expiry_(expiry),
        observer_(offer) {
    if (mailbox_ == nullptr) return;
    if constexpr (!kLiesInSlot<In>) arguments_ = std::make_unique<In[]>(mailbox_->storage());
    if constexpr (kHasResult) results_ = std::make_unique<Out[]>(mailbox_->completions().size());
  }

  static constexpr Mailbox::SlotShape Shape() {
    return kLiesInSlot<In> ? Mailbox::SlotShape{sizeof(In), alignof(In)} : Mailbox::SlotShape{};
  }

  Status Execute(const In& in, Out& out) override {
    if (mailbox_ == nullptr) return ExecuteNow(in, out);
    if constexpr (kHasResult) return Status::kUnsupported;
    std::byte* argument = nullptr;
    const Status claimed = Claim(in, argument);
    if (!claimed) return observer_.ShowOther<Out>(CallOutcome::kRefused, claimed, in);
    mailbox_->Publish(argument, *this);
    return claimed;
  }

  /// Decodes the argument directly into its slot, without a copy. Therefore, a malformed argument
  /// occupies a slot until the server skips it. If the mailbox refuses the call, the caller gets
  /// the mailbox's status even for a malformed argument.
  Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& out) override {
    if (mailbox_ == nullptr || kHasResult) return Command<In, Out>::ExecuteEncoded(in, out);
    std::byte* argument = nullptr;
    const Status claimed = ClaimDecoded(in, argument);
    if (!claimed) return ShowRefused(claimed, in);
    mailbox_->Publish(argument, *this);
    this->Put(Out{}, out);
    return claimed;
  }

  Status Wait(const In& in, Out& out, std::chrono::nanoseconds timeout) override {
    if (mailbox_ == nullptr) return ExecuteNow(in, out);
    if (mailbox_->is_executed_here()) {
      return observer_.ShowOther<Out>(CallOutcome::kRefused, Status::kWouldDeadlock, in);
    }
    std::size_t record = 0;
    const Status posted = Post(in, nullptr, record);
    return posted == Status::kQueued ? Await(record, out, DeadlineAfter(timeout)) : posted;
  }

  Status Begin(const In& in, Out& out, Wakeup<>& ended, std::size_t& call) override {
    return mailbox_ == nullptr ? ExecuteNow(in, out) : Post(in, &ended, call);
  }
  [[nodiscard]] bool HasEnded(std::size_t call) override {
    CompletionPool& completions = mailbox_->completions();
    return completions[call].is_done() || completions.cancelled() || !mailbox_->accepting();
  }
  Status End(std::size_t call, Out& out) override { return Await(call, out, SteadyTime{}); }

  void SetClient(const std::shared_ptr<const std::string>& client) override {
    observer_.SetClient(client);
  }
  [[nodiscard]] const CallObserver& observer() const { return observer_; }

 private:
  static constexpr bool kHasResult = !std::is_same_v<Out, None>;

  friend class BlockingCallEntry<QueuedCommand>;

  Status ExecuteNow(const In& in, Out& out) {
    if (component_ != nullptr && !component_->accepting()) {
      return observer_.ShowOther<Out>(CallOutcome::kRefused, Status::kNotActive, in);
    }
    return ComponentAccess::CatchExceptions(component_, [&]() -> Status {
      if (observer_.is_on()) {
        observer_.ShowExecution(in, out, [&] { handler_(in, out); });
      } else {
        handler_(in, out);
      }
      return Status::kDone;
    });
  }

  /// Claims a slot and copies the argument. After kQueued, the argument is in the claimed slot,
  /// which must be published. After any other status nothing has changed: the mailbox has refused
  /// the call, or the copy has thrown (kFailed).
  Status Claim(const In& in, std::byte*& argument) {
    argument = mailbox_->Claim();
    if (argument == nullptr) return mailbox_->refusal();
    if constexpr (kLiesInSlot<In>) {
      new (argument) In(in);
      return Status::kQueued;
    } else {
      const Status copied = Copy(in, arguments_[mailbox_->SlotOf(argument)]);
      if (!copied) mailbox_->GiveUp(argument);
      return copied;
    }
  }
  /// Like Claim(), but for an encoded argument. Returns kInvalid if the argument cannot be decoded,
  /// and kFailed if the codec throws.
  Status ClaimDecoded(std::span<const std::byte> in, std::byte*& argument) {
    argument = mailbox_->Claim();
    if (argument == nullptr) return mailbox_->refusal();
    const Status decoded = ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      In* value = nullptr;
      if constexpr (kLiesInSlot<In>) {
        value = new (argument) In{};
      } else {
        value = &arguments_[mailbox_->SlotOf(argument)];
      }
      if constexpr (std::is_same_v<In, None>) return Status::kQueued;
      return Decode(in, *value) ? Status::kQueued : Status::kInvalid;
    });
    if (!decoded) mailbox_->GiveUp(argument);
    return decoded;
  }
  template <typename T>
  static Status Copy(const T& from, T& to) {
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      to = from;
      return Status::kQueued;
    });
  }

  /// Puts the call into the mailbox, with a completion record.
  Status Post(const In& in, Wakeup<>* ended, std::size_t& taken) {
    CompletionPool& completions = mailbox_->completions();
    const auto record = completions.Take();
    if (!record) {
      mailbox_->CountRefused();
      return observer_.ShowOther<Out>(CallOutcome::kRefused, Status::kQueueFull, in);
    }
    if (ended != nullptr) completions[*record].SetListener(*ended);
    std::byte* argument = nullptr;
    if (const Status claimed = Claim(in, argument); !claimed) {
      completions[*record].Free();
      return observer_.ShowOther<Out>(CallOutcome::kRefused, claimed, in);
    }
    completions.Assign(mailbox_->SlotOf(argument), *record);
    mailbox_->Publish(argument, blocking_entry_);
    taken = *record;
    return Status::kQueued;
  }

  Status Await(std::size_t record, Out& out, SteadyTime deadline) {
    using Ending = Completion<>::Ending;
    Completion<>& completion = mailbox_->completions()[record];
    const auto is_cancelled = [this] { return mailbox_->completions().cancelled(); };
    const auto is_hopeless = [&] { return is_cancelled() || !mailbox_->accepting(); };
    const Ending ending = completion.Await(is_hopeless, deadline);
    if (ending == Ending::kStarted) return Status::kOutcomeUnknown;
    if (ending == Ending::kNotStarted) {
      if (is_cancelled()) return Status::kNotConnected;
      return mailbox_->accepting() ? Status::kTimeout : Status::kNotActive;
    }
    Status status = completion.status();
    if constexpr (kHasResult) {
      if (status && !Copy(results_[record], out)) status = Status::kFailed;
    }
    completion.Free();
    return status;
  }

  void ExecuteSlot(std::byte* argument, std::size_t slot) override { Run(argument, slot, 0); }
  void DropSlot(std::byte* argument, std::size_t slot) noexcept override {
    ShowNotExecuted(CallOutcome::kDropped, Status::kNotActive, argument, slot);
  }

  void ExecuteBlockingCall(std::byte* argument, std::size_t slot) {
    const std::size_t record = mailbox_->completions().RecordOf(slot);
    Completion<>& completion = mailbox_->completions()[record];
    if (!completion.Start()) {
      ShowNotExecuted(CallOutcome::kExpired, Status::kTimeout, argument, slot);
      return;
    }
    try {
      Run(argument, slot, record);
    } catch (...) {
      completion.Finish(Status::kFailed);
      throw;
    }
    completion.Finish(Status::kDone);
  }
  void DropBlockingCall(std::byte* argument, std::size_t slot) noexcept {
    CompletionPool& completions = mailbox_->completions();
    Completion<>& completion = completions[completions.RecordOf(slot)];
    if (completion.Start()) completion.Finish(Status::kNotActive);
    DropSlot(argument, slot);
  }

  void Run(std::byte* argument, std::size_t slot, [[maybe_unused]] std::size_t record) {
    if (expiry_ != nullptr) expiry_->Renew(mailbox_->number());
    const In& in = ArgumentIn(argument, slot);
    if constexpr (kHasResult) {
      Handle(in, results_[record]);
    } else {
      None nothing;
      Handle(in, nothing);
    }
  }
  /// The flag of the mailbox is beside the flags that the executing thread has just read.
  void Handle(const In& in, Out& out) {
    const bool is_observed = mailbox_->is_observed() && observer_.is_on();
    if (!is_observed) return handler_(in, out);
    observer_.ShowExecution(in, out, [&] { handler_(in, out); });
  }

  [[nodiscard]] const In& ArgumentIn(std::byte* argument, std::size_t slot) const {
    if constexpr (kLiesInSlot<In>) {
      return *std::launder(reinterpret_cast<const In*>(argument));
    } else {
      return arguments_[slot];
    }
  }

  void ShowNotExecuted(CallOutcome outcome, Status status, std::byte* argument,
                       std::size_t slot) const noexcept {
    (void)observer_.ShowOther<Out>(outcome, status, ArgumentIn(argument, slot));
  }
  /// Shows a refused call to the observers, unless its argument cannot be decoded.
  Status ShowRefused(Status status, std::span<const std::byte> in) const {
    if (status == Status(Status::kInvalid) || !observer_.is_on()) return status;
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      In argument{};
      if constexpr (!std::is_same_v<In, None>) {
        if (!Decode(in, argument)) return status;
      }
      return observer_.ShowOther<Out>(CallOutcome::kRefused, status, argument);
    });
  }

  Handler handler_;
  Mailbox* mailbox_;
  const ComponentAccess* component_;
  Expiry* expiry_;
  BlockingCallEntry<QueuedCommand> blocking_entry_{*this};
  std::unique_ptr<In[]> arguments_;  // one per slot
  std::unique_ptr<Out[]> results_;   // one per completion record
  CallObserver observer_;
};

}  // namespace tendon
