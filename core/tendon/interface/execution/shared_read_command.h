#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/execution/component_access.h>
#include <tendon/interface/offer.h>

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace tendon {

/// A read command for a shared value, which must never change after the command has returned it.
/// Runs `body() -> std::shared_ptr<const Out>` in the caller's thread. Returns kNoSample if the
/// pointer is null, and kFailed if `body` throws. An encoded read encodes the value without copying
/// it first.
///
/// The last thread that uses the value frees it. This can be the caller's thread, so a real-time
/// cycle should not read large values this way.
template <Payload Out, typename Body>
class SharedReadCommand final : public Command<None, Out> {
 public:
  explicit SharedReadCommand(Body body) : body_(std::move(body)) {}

  Status Execute(const None& /*in*/, Out& out) override {
    return With([&out](const Out& value) -> Status {
      out = value;
      return Status::kDone;
    });
  }
  /// Returns kFailed if the size of the value changes during the read, which is a mistake of the
  /// author.
  Status ExecuteEncoded(std::span<const std::byte> /*in*/, ReplySink& out) override {
    return With([&out](const Out& value) -> Status {
      const std::span<std::byte> room = out.Room(EncodedSize(value));
      const bool is_whole = room.empty() || EncodeTo(value, room) == room.size();
      return is_whole ? Status::kDone : Status::kFailed;
    });
  }

 private:
  template <typename Use>
  Status With(Use use) {
    return ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      const std::shared_ptr<const Out> value = body_();
      return value ? use(*value) : Status::kNoSample;
    });
  }

  Body body_;
};

/// Makes a SharedReadCommand for each connection, with a copy of `body`.
template <Payload Out, typename Body>
class SharedReadOffer final : public Offer {
 public:
  SharedReadOffer(MemberDescription description, Body body)
      : Offer(std::move(description)), body_(std::move(body)) {}

  [[nodiscard]] bool uses_mailbox() const override { return false; }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* /*mailbox*/) const override {
    return std::make_unique<SharedReadCommand<Out, Body>>(body_);
  }

 private:
  Body body_;
};

}  // namespace tendon
