#pragma once

#include <tendon/base/clock.h>
#include <tendon/interface/event_base.h>
#include <tendon/interface/observed_call.h>
#include <tendon/lockfree/flag.h>

#include <memory>
#include <string>
#include <utility>

namespace tendon {

/// Shows the calls of one command to observers, such as a recorder. Observers see an event whose
/// value is an observed call, see SchemaOfCalls(). The thread of the component raises it when it
/// has executed a call, and a caller raises it when its call was refused. Raising the event never
/// waits, locks or throws. A call that does not reach an observer is counted as a lost event.
class CallEvent final : public EventBase {
 public:
  CallEvent() { SetRaisers(CallerThreads::kManyThreads, nullptr); }

  /// From now on, `is_observed` is true and the mailboxes of `inbox`, which may be null, are marked
  /// while there are observers. Both objects must exist during that time.
  void SetTarget(Flag& is_observed, Inbox* inbox) {
    is_observed_ = &is_observed;
    inbox_ = inbox;
  }

  void Raise(const ArgumentWriter& call) noexcept;

 private:
  /// Observers are called with encoded values.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }
  void OnSubscribersChanged(bool has_subscribers) override;

  Flag* is_observed_ = nullptr;
  Inbox* inbox_ = nullptr;
};

/// The switches that the calls of an offer check. Both are in one word, so the check for observers
/// needs no other cache line than the check whether the command is enabled.
class CallSwitches {
 public:
  /// After Disable(), callers of the command get kDisabled. Calls that are already queued are still
  /// executed. Any thread.
  void Enable() noexcept { is_enabled_.Set(true); }
  void Disable() noexcept { is_enabled_.Set(false); }
  [[nodiscard]] const Flag& enabled() const noexcept { return is_enabled_; }

  [[nodiscard]] bool is_observed() const noexcept { return is_observed_.Get(); }
  /// Only for offers that have or had observers.
  [[nodiscard]] CallEvent& calls() const noexcept { return *calls_; }

  // For managers, one at a time.

  /// From now on, uses `calls`, which other code may raise, too. Must be called before
  /// ObserveCalls().
  void SetCalls(std::shared_ptr<CallEvent> calls) { calls_ = std::move(calls); }
  /// Returns the event to which observers subscribe. `inbox` is the inbox of the component, or
  /// null.
  CallEvent& ObserveCalls(Inbox* inbox) {
    if (!calls_) calls_ = std::make_shared<CallEvent>();
    calls_->SetTarget(is_observed_, inbox);
    return *calls_;
  }

 private:
  Flag is_enabled_{true};
  Flag is_observed_;
  std::shared_ptr<CallEvent> calls_;  // made for the first observer, and kept
};

/// Shows the calls of one bound command to the observers of its offer.
class CallObserver {
 public:
  /// If `offer` is null, shows nothing.
  explicit CallObserver(const CallSwitches* offer = nullptr) : offer_(offer) {}

  void SetClient(std::shared_ptr<const std::string> client) { client_ = std::move(client); }

  [[nodiscard]] bool is_on() const noexcept { return offer_ != nullptr && offer_->is_observed(); }

  /// Runs `execute()`, which may throw, and shows the call. Must be called only if is_on().
  template <Payload In, Payload Out, typename Execute>
  void ShowExecution(const In& in, const Out& out, Execute execute) const {
    const SteadyTime begin = SteadyClock().Now();
    CallHeader header;
    try {
      execute();
    } catch (...) {
      header = {SteadyClock().Now() - begin, CallOutcome::kFailed, Status::kFailed};
      Show<In, Out>(header, in, nullptr);  // `out` may still have the result of an earlier call
      throw;
    }
    header.took = SteadyClock().Now() - begin;
    Show(header, in, &out);
  }
  /// Returns `status`. If there are observers, also shows them the call, which has no result.
  template <Payload Out = None, Payload In>
  Status ShowOther(CallOutcome outcome, Status status, const In& in) const noexcept {
    if (is_on()) {
      Show<In, Out>({.took = {}, .outcome = outcome, .status = status.code()}, in, nullptr);
    }
    return status;
  }

 private:
  template <Payload In, Payload Out>
  void Show(const CallHeader& header, const In& in, const Out* out) const noexcept {
    static const std::string nobody;
    offer_->calls().Raise(ObservedCallWriter(header, in, out, client_ ? *client_ : nobody));
  }

  const CallSwitches* offer_;
  std::shared_ptr<const std::string> client_;
};

}  // namespace tendon
