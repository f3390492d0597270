#pragma once

#include <tendon/interface/execution/latest_value.h>
#include <tendon/interface/execution/queued_command.h>

#include <chrono>
#include <cstdint>

namespace tendon {

/// A queued command that keeps only the latest call. A new call replaces an older call that is
/// still queued, so a full mailbox never refuses it. A token in the mailbox represents the queued
/// call. While one token is executed, one more may be queued, so two slots are reserved. A call
/// whose caller waits uses a slot of its own.
template <Payload In, typename Handler>
class LatestCommand final : public Command<In, None>, private Mailbox::Entry {
 public:
  LatestCommand(const Handler& handler, Mailbox& mailbox, Expiry* expiry)
      : handler_(handler),
        queued_(handler, &mailbox, nullptr, expiry),
        newest_(mailbox),
        number_(mailbox.number()),
        expiry_(expiry) {}

  static constexpr Mailbox::SlotShape Shape() {
    Mailbox::SlotShape shape = QueuedCommand<In, None, Handler>::Shape();
    shape.reserve = 2;
    return shape;
  }

  Status Execute(const In& in, None& /*out*/) override {
    return newest_.Post(*this, [&in]() -> const In& { return in; });  // a copy may throw
  }

  Status Wait(const In& in, None& out, std::chrono::nanoseconds timeout) override {
    return queued_.Wait(in, out, timeout);
  }
  Status Begin(const In& in, None& out, Wakeup<>& ended, std::size_t& call) override {
    return queued_.Begin(in, out, ended, call);
  }
  [[nodiscard]] bool HasEnded(std::size_t call) override { return queued_.HasEnded(call); }
  Status End(std::size_t call, None& out) override { return queued_.End(call, out); }

 private:
  void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {
    None nothing;
    const In* const in = newest_.Take();
    if (in == nullptr) return;
    if (expiry_ != nullptr) expiry_->Renew(number_);
    handler_(*in, nothing);
  }
  void DropSlot(std::size_t /*slot*/) noexcept override { newest_.Take(); }

  Handler handler_;
  QueuedCommand<In, None, Handler> queued_;
  LatestValue<In> newest_;
  std::uint64_t number_;
  Expiry* expiry_;
};

}  // namespace tendon
