#pragma once

#include <tendon/interface/execution/call_observer.h>
#include <tendon/interface/execution/direct_command.h>
#include <tendon/interface/execution/filtered_command.h>
#include <tendon/interface/execution/latest_command.h>
#include <tendon/interface/execution/queued_command.h>
#include <tendon/interface/interface_description.h>
#include <tendon/payload/schema.h>

#include <chrono>
#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

namespace tendon {

/// Describes a member by its payload types.
template <Payload In, Payload Out>
// NOLINTNEXTLINE(performance-unnecessary-value-param): it is moved on
MemberDescription DescribeMember(std::string name, CommandKind kind) {
  return {.name = std::move(name),
          .signature = SignatureOf<In, Out>(kind),
          .in_type = SchemaOf<In>().TypeName(),
          .out_type = SchemaOf<Out>().TypeName(),
          .optional = false,
          .hazard = {},
          .expires_after = 0.0};
}

/// The effect of a full mailbox on a call.
enum class Overflow {
  kRefuse,      ///< the call is refused with kQueueFull
  kLatestOnly,  ///< never refused: the call replaces an older queued call of the command
};

class ColumnBase;
class StateTable;

/// A column of a state table; null pointers without a column.
struct ColumnSource {
  const StateTable* table = nullptr;
  const ColumnBase* column = nullptr;
};

/// An operation that a component offers: a command of a provided interface, or an event handler of
/// a required one. Each connection gets its own command, made by Bind().
class Offer : public CallSwitches {
 public:
  explicit Offer(MemberDescription description) : description_(std::move(description)) {}
  Offer(const Offer&) = delete;
  Offer& operator=(const Offer&) = delete;
  virtual ~Offer() = default;

  [[nodiscard]] const MemberDescription& description() const { return description_; }
  /// Declares that a call is dangerous, for example "motion". Viewers then ask the user before they
  /// call.
  Offer& SetHazard(std::string hazard) {
    description_.hazard = std::move(hazard);
    return *this;
  }
  /// Sets the effect of a full mailbox. Only for queued void and write commands, and for handlers.
  /// Call it in the constructor.
  Offer& SetOverflow(Overflow overflow) {
    overflow_ = overflow;
    return *this;
  }
  [[nodiscard]] Overflow overflow() const { return overflow_; }
  /// True if overflow() is kLatestOnly and this kind of offer uses it.
  [[nodiscard]] bool keeps_latest_only() const {
    return overflow_ == Overflow::kLatestOnly && uses_mailbox() &&
           !WaitsForServer(description_.signature.kind);
  }

  /// Limits how long the effect of a call lasts. Then a robot stops when the connection to its
  /// operator breaks. `method` runs if no call was executed for the time `after` (1 ms to 3600 s),
  /// or if the client of the last call is gone. Every executed call renews the effect, even if the
  /// command's own code refuses the request.
  ///
  /// `method`, or `function`, runs in the component's thread, in ProcessQueuedCommands() or at the
  /// end of the next cycle. It also runs if another command has ended or replaced the effect, so it
  /// must check whether the effect still lasts.
  ///
  /// Call this function in the constructor, for queued commands of a task. Throws
  /// ConfigurationError for commands that are not queued.
  template <typename Owner, std::derived_from<Owner> Object>
  Offer& ExpiresAfter(std::chrono::nanoseconds after, void (Owner::*method)(), Object* object) {
    return SetExpiry(after, [method, object] { (object->*method)(); });
  }
  Offer& ExpiresAfter(std::chrono::nanoseconds after, std::function<void()> function) {
    return SetExpiry(after, std::move(function));
  }
  /// Null if the effect of a call has no time limit.
  [[nodiscard]] Expiry* expiry() const { return expiry_.get(); }

  /// Declares that a call returns the newest value of a column, which must outlive the offer.
  Offer& SetSource(const ColumnSource& source) {
    source_ = source;
    return *this;
  }
  [[nodiscard]] const ColumnSource& source() const { return source_; }

  /// Declares that each call is refused. `sentence` says why, and consoles show it. Callers that do
  /// not show it get the status that the command returns. Interfaces still connect.
  Offer& SetRefusal(std::string sentence) {
    refusal_ = std::move(sentence);
    return *this;
  }
  /// Empty if calls are not refused.
  [[nodiscard]] const std::string& refusal() const { return refusal_; }

  /// Sets the component; called by its interface. The component must outlive all commands.
  void SetComponent(const ComponentAccess* component) { component_ = component; }

  /// Declares that a call only copies from a state table, and runs no code of the component.
  Offer& SetReadsTableOnly() {
    reads_table_only_ = true;
    return *this;
  }
  /// True if a call runs code of the component in the caller's thread, which may take long.
  /// `has_mailbox` says whether the offer is bound to a mailbox.
  [[nodiscard]] virtual bool RunsInCaller(bool has_mailbox) const {
    return uses_mailbox() ? !has_mailbox : !reads_table_only_;
  }

  /// True if slots of the mailbox refer to the result of Bind(). Then both must be freed together.
  [[nodiscard]] virtual bool uses_mailbox() const { return true; }
  /// The memory that the argument needs in a mailbox slot.
  [[nodiscard]] virtual Mailbox::SlotShape shape() const { return {}; }
  /// Makes a command for one connection. `mailbox` is null if calls run in the caller's thread; it
  /// must outlive the command.
  [[nodiscard]] virtual std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const = 0;

 protected:
  [[nodiscard]] const ComponentAccess* component() const { return component_; }

 private:
  Offer& SetExpiry(std::chrono::nanoseconds after, std::function<void()> end);

  MemberDescription description_;
  std::unique_ptr<Expiry> expiry_;
  Overflow overflow_ = Overflow::kRefuse;
  ColumnSource source_;
  bool reads_table_only_ = false;
  std::string refusal_;
  const ComponentAccess* component_ = nullptr;
};

/// Runs `handler(in, out)` in the server's thread.
template <Payload In, Payload Out, typename Handler>
class QueuedOffer : public Offer {
 public:
  QueuedOffer(MemberDescription description, Handler handler)
      : Offer(std::move(description)), handler_(std::move(handler)) {}

  [[nodiscard]] Mailbox::SlotShape shape() const final {
    if constexpr (kMayReplace) {
      if (overflow() == Overflow::kLatestOnly) return LatestCommand<In, Handler>::Shape();
    }
    return QueuedCommand<In, Out, Handler>::Shape();
  }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override {
    return BindTyped(mailbox, this);
  }

 protected:
  /// Observers of `observed`, which may be null, see the calls.
  [[nodiscard]] std::unique_ptr<Command<In, Out>> BindTyped(Mailbox* mailbox,
                                                            const CallSwitches* observed) const {
    if constexpr (kMayReplace) {
      if (overflow() == Overflow::kLatestOnly && mailbox != nullptr) {
        return std::make_unique<LatestCommand<In, Handler>>(handler_, *mailbox, expiry(), observed);
      }
    }
    return std::make_unique<QueuedCommand<In, Out, Handler>>(handler_, mailbox, this->component(),
                                                             expiry(), observed);
  }

 private:
  static constexpr bool kMayReplace = std::is_same_v<Out, None>;

  Handler handler_;
};

/// A queued write: `filter(in, filtered)` runs in the caller's thread, and `filtered` is queued.
template <Payload In, Payload Filtered, typename Filter, typename Handler>
class FilteredOffer final : public QueuedOffer<Filtered, None, Handler> {
 public:
  FilteredOffer(MemberDescription description, Filter filter, Handler handler)
      : QueuedOffer<Filtered, None, Handler>(std::move(description), std::move(handler)),
        filter_(std::move(filter)) {}

  [[nodiscard]] bool RunsInCaller(bool /*has_mailbox*/) const override { return true; }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override {
    return std::make_unique<FilteredCommand<In, Filtered, Filter>>(
        filter_, this->BindTyped(mailbox, nullptr), this);
  }

 private:
  Filter filter_;
};

/// The side that is at fault if code throws in the caller's thread.
enum class ExceptionPolicy {
  kCaller,     ///< the caller gets kFailed, because its argument may be the cause
  kComponent,  ///< in addition, the component is faulted
};

/// Runs `body` in the caller's thread. Each connection gets a copy of `body`, which may contain a
/// Scratch.
template <Payload In, Payload Out, typename Body>
class DirectOffer final : public Offer {
 public:
  DirectOffer(MemberDescription description, Body body, ExceptionPolicy exception_policy)
      : Offer(std::move(description)),
        body_(std::move(body)),
        exception_policy_(exception_policy) {}

  [[nodiscard]] bool uses_mailbox() const override { return false; }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* /*mailbox*/) const override {
    return std::make_unique<DirectCommand<In, Out, Body>>(
        body_, exception_policy_ == ExceptionPolicy::kComponent ? component() : nullptr, this);
  }

 private:
  Body body_;
  ExceptionPolicy exception_policy_;
};

}  // namespace tendon
