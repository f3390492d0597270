#pragma once

#include <tendon/interface/execution/latest_value.h>
#include <tendon/interface/execution/queued_command.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>

namespace tendon {

/// A queued command that keeps only the latest call. A new call replaces an older call that is
/// still queued, so a full mailbox never refuses it. A token in the mailbox represents the queued
/// call. While one token is executed, one more may be queued, so two slots are reserved. A call
/// whose caller waits uses a separate slot.
template <Payload In, typename Handler>
class LatestCommand final : public Command<In, None>, private Mailbox::Entry {
 public:
  /// Observers of `offer`, which may be null, see each call, except calls that a newer call has
  /// replaced.
  LatestCommand(const Handler& handler, Mailbox& mailbox, Expiry* expiry,
                const CallSwitches* offer = nullptr)
      : handler_(handler),
        queued_(handler, &mailbox, nullptr, expiry, offer),
        newest_(mailbox),
        mailbox_(mailbox),
        expiry_(expiry) {}

  static constexpr Mailbox::SlotShape Shape() {
    Mailbox::SlotShape shape = QueuedCommand<In, None, Handler>::Shape();
    shape.reserve = 2;
    return shape;
  }

  Status Execute(const In& in, None& /*out*/) override {
    const Status posted = newest_.Post(*this, [&in](In& place) { place = in; });  // may throw
    if (posted) return posted;
    return queued_.observer().ShowOther(CallOutcome::kRefused, posted, in);
  }

  Status Wait(const In& in, None& out, std::chrono::nanoseconds timeout) override {
    return queued_.Wait(in, out, timeout);
  }
  Status Begin(const In& in, None& out, Wakeup<>& ended, std::size_t& call) override {
    return queued_.Begin(in, out, ended, call);
  }
  [[nodiscard]] bool HasEnded(std::size_t call) override { return queued_.HasEnded(call); }
  Status End(std::size_t call, None& out) override { return queued_.End(call, out); }

  void SetClient(const std::shared_ptr<const std::string>& client) override {
    queued_.SetClient(client);
  }

 private:
  void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {
    None nothing;
    const In* const in = newest_.Take();
    if (in == nullptr) return;
    if (expiry_ != nullptr) expiry_->Renew(mailbox_.number());
    const CallObserver& observer = queued_.observer();
    const bool is_observed = mailbox_.is_observed() && observer.is_on();
    if (!is_observed) return handler_(*in, nothing);
    observer.ShowExecution(*in, nothing, [&] { handler_(*in, nothing); });
  }
  void DropSlot(std::byte* /*argument*/, std::size_t /*slot*/) noexcept override {
    const In* const in = newest_.Take();
    if (in == nullptr) return;
    (void)queued_.observer().ShowOther(CallOutcome::kDropped, Status::kNotActive, *in);
  }

  Handler handler_;
  QueuedCommand<In, None, Handler> queued_;
  LatestValue<In> newest_;
  Mailbox& mailbox_;
  Expiry* expiry_;
};

}  // namespace tendon
