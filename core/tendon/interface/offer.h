#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/description.h>
#include <tendon/payload/schema.h>

#include <memory>
#include <utility>

namespace tendon {

/// Describes a member by its payload types.
template <Payload In, Payload Out>
MemberDescription DescribeMember(std::string name, CommandKind kind) {
  return {.name = std::move(name),
          .signature = SignatureOf<In, Out>(kind),
          .in_type = SchemaOf<In>().name(),
          .out_type = SchemaOf<Out>().name(),
          .optional = false,
          .hazard = {}};
}

/// What a component lets others execute: a command of a provided interface, or an event handler of
/// a required one. Every connection gets a command of its own from it.
class Offer {
 public:
  explicit Offer(MemberDescription description) : description_(std::move(description)) {}
  Offer(const Offer&) = delete;
  Offer& operator=(const Offer&) = delete;
  virtual ~Offer() = default;

  [[nodiscard]] const MemberDescription& description() const { return description_; }
  /// Says what a call can do to the world: "motion". Viewers then ask before they call.
  Offer& SetHazard(std::string hazard) {
    description_.hazard = std::move(hazard);
    return *this;
  }
  /// The room its argument needs in a mailbox' slot.
  [[nodiscard]] virtual Mailbox::SlotShape shape() const { return {}; }
  /// A command for one caller. `mailbox` is null where calls run in the caller's thread; it
  /// outlives the command.
  [[nodiscard]] virtual std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const = 0;

 private:
  MemberDescription description_;
};

/// A void or write command, or a handler of a void or write event.
template <Payload In, typename Handler>
class QueuedOffer final : public Offer {
 public:
  QueuedOffer(MemberDescription description, Handler handler)
      : Offer(std::move(description)), handler_(std::move(handler)) {}

  [[nodiscard]] Mailbox::SlotShape shape() const override {
    return QueuedCommand<In, Handler>::Shape();
  }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override {
    return std::make_unique<QueuedCommand<In, Handler>>(handler_, mailbox);
  }

 private:
  Handler handler_;
};

/// A read or qualified read command. Every caller gets a copy of `body`, so it may have scratch
/// space of its own.
template <Payload In, Payload Out, typename Body>
class DirectOffer final : public Offer {
 public:
  DirectOffer(MemberDescription description, Body body)
      : Offer(std::move(description)), body_(std::move(body)) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* /*mailbox*/) const override {
    return std::make_unique<DirectCommand<In, Out, Body>>(body_);
  }

 private:
  Body body_;
};

}  // namespace tendon
