#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/execution/host.h>
#include <tendon/interface/offer.h>

#include <memory>
#include <span>
#include <utility>

namespace tendon {

/// Runs `body() -> std::shared_ptr<const Out>` in the caller's thread, for a value that nobody
/// changes any more. Whoever wants it encoded gets it from where it lies: it is not copied before.
/// Null is kNoSample; what the body throws, kFailed.
template <Payload Out, typename Body>
class SharedReadCommand final : public Command<None, Out> {
 public:
  explicit SharedReadCommand(Body body) : body_(std::move(body)) {}

  Status Execute(const None& /*in*/, Out& out) override {
    std::shared_ptr<const Out> value;
    const Status status = Get(value);
    if (status) out = *value;
    return status;
  }
  Status ExecuteEncoded(std::span<const std::byte> /*in*/, AnswerSink& out) override {
    std::shared_ptr<const Out> value;
    const Status status = Get(value);
    if (status) EncodeTo(*value, out.Room(EncodedSize(*value)));
    return status;
  }

 private:
  Status Get(std::shared_ptr<const Out>& value) {
    return Host::Contain(nullptr, [&]() -> Status {
      value = body_();
      return value ? Status::kDone : Status::kNoSample;
    });
  }

  Body body_;
};

/// Every connection gets a copy of `body`.
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
