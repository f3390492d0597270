#pragma once

#include <tendon/interface/function.h>
#include <tendon/interface/inbox.h>
#include <tendon/interface/offer.h>

#include <chrono>
#include <concepts>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

enum class Need { kRequired, kOptional };

/// A named set of functions and event handlers that a component needs filled by a provided
/// interface. Filled in the component's constructor; the rules are those of ProvidedInterface.
class RequiredInterface {
 public:
  /// `inbox` is where events wait; null when handlers run in the thread that raises them.
  RequiredInterface(std::string name, Inbox* inbox, Need need = Need::kRequired)
      : name_(std::move(name)), inbox_(inbox), need_(need) {}
  RequiredInterface(const RequiredInterface&) = delete;
  RequiredInterface& operator=(const RequiredInterface&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] Inbox* inbox() const { return inbox_; }

  /// `function` is a member of the component; it calls the command of this name.
  template <CommandKind kKind, Payload In, Payload Out>
  void AddFunction(Function<kKind, In, Out>& function, std::string name,
                   Need need = Need::kRequired) {
    MemberDescription description = DescribeMember<In, Out>(std::move(name), kKind);
    description.optional = need == Need::kOptional;
    function.index_ = AddCaller(function, std::move(description));
    function.binding_ = &binding_;
  }

  /// Queued to the component's thread; runs in its ProcessQueuedCommands().
  template <typename Owner, std::derived_from<Owner> Object>
  void AddEventHandlerVoid(void (Owner::*method)(), Object* object, std::string name,
                           Need need = Need::kRequired) {
    AddHandler<None>(CommandKind::kVoid, std::move(name), need,
                     [method, object](const None&) { (object->*method)(); });
  }
  template <typename Owner, typename Argument, std::derived_from<Owner> Object>
  void AddEventHandlerWrite(void (Owner::*method)(Argument), Object* object, std::string name,
                            Need need = Need::kRequired) {
    using In = std::remove_cvref_t<Argument>;
    AddHandler<In>(CommandKind::kWrite, std::move(name), need,
                   [method, object](const In& in) { (object->*method)(in); });
  }

  /// For members that are made at run time. The caller's place in the binding is returned.
  std::size_t AddCaller(Caller& caller, MemberDescription description);
  void AddOffer(std::unique_ptr<Offer> handler);
  [[nodiscard]] BindingPointer& binding() { return binding_; }

  /// How many calls may wait at the server, and how many events here; 64 unless set before the
  /// connection is made. 1 to 2^24.
  void SetMailboxCapacity(std::size_t capacity);
  [[nodiscard]] std::size_t mailbox_capacity() const { return mailbox_capacity_; }

  /// How long a read waits for the answer of another process; 100 ms unless set before the
  /// connection is made. At least 1 ms.
  void SetReadDeadline(std::chrono::milliseconds deadline);
  [[nodiscard]] std::chrono::milliseconds read_deadline() const { return read_deadline_; }

  [[nodiscard]] RequiredDescription description() const;
  [[nodiscard]] bool is_connected() const { return binding_.Get() != nullptr; }

  void Seal() { sealed_ = true; }

 private:
  friend class Connection;

  struct NamedCaller {
    MemberDescription description;
    Caller* caller;
  };

  template <Payload In, typename Handler>
  void AddHandler(CommandKind kind, std::string name, Need need, Handler handler) {
    MemberDescription description = DescribeMember<In, None>(std::move(name), kind);
    description.optional = need == Need::kOptional;
    AddOffer(
        std::make_unique<QueuedOffer<In, Handler>>(std::move(description), std::move(handler)));
  }
  void CheckNew(const std::string& what, const std::string& name) const;

  static constexpr std::size_t kDefaultCapacity = 64;
  static constexpr std::chrono::milliseconds kDefaultReadDeadline{100};

  std::string name_;
  Inbox* inbox_;
  Need need_;
  bool sealed_ = false;
  std::size_t mailbox_capacity_ = kDefaultCapacity;
  std::chrono::milliseconds read_deadline_ = kDefaultReadDeadline;
  std::vector<NamedCaller> callers_;
  std::vector<std::unique_ptr<Offer>> handlers_;
  BindingPointer binding_;
};

}  // namespace tendon
