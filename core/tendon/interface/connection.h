#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/interface/required_interface.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// A required interface bound to a provided one, both in this process: a mailbox for commands, a
/// mailbox for events, and the commands in between. Lives from Make() to its destruction.
///
/// Used by managers only, one at a time; both components may run meanwhile.
class Connection {
 public:
  /// Binds all functions and handlers, or nothing: kIncompatible with the sentence that names both
  /// ends, or where a task would wait for itself; kExists when `required` is connected already. The
  /// interfaces must outlive the connection. A component that requires hears of it in its own
  /// thread before its functions reach the other end (Component::OnConnected); one without a thread
  /// here, before anything is bound.
  static Result<std::unique_ptr<Connection>> Make(RequiredInterface& required,
                                                  ProvidedInterface& provided,
                                                  const std::string& required_name,
                                                  const std::string& provided_name);

  /// Bytes of the slots of the mailboxes that Make() opens.
  [[nodiscard]] static std::size_t MailboxBytes(const RequiredInterface& required,
                                                const ProvidedInterface& provided);

  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  /// Close() with no patience, if it was not called.
  ~Connection();

  /// No call and no event enters any more; lets both ends execute what they accepted for at most
  /// `patience`. Then whoever still waits for a call gets kNotConnected, and everything is freed;
  /// what a handler uses that does not return is freed once it has. Both components hear of it in
  /// their own threads (Component::OnDisconnected, OnClientGone); one without a thread that
  /// requires hears of it here, first of all. Returns how many accepted calls and events were
  /// dropped. Never from a thread that executes either end's mailboxes.
  std::size_t Close(std::chrono::milliseconds patience);

  /// When it was made.
  [[nodiscard]] SteadyTime made() const { return made_; }
  /// Calls that have left the server's mailbox, and events that have left the client's. Reads do
  /// not wait in any: they are not counted.
  [[nodiscard]] std::uint64_t taken() const;
  /// Calls that the server's mailbox holds at most; 0 where calls do not wait.
  [[nodiscard]] std::size_t capacity() const;
  /// Calls waiting at the server now.
  [[nodiscard]] std::size_t waiting() const;
  /// Calls refused because the server's mailbox was full.
  [[nodiscard]] std::uint64_t refused() const;
  /// Calls replaced by newer ones, of commands that keep the latest only.
  [[nodiscard]] std::uint64_t replaced() const;
  /// Events that have not reached the client: RequiredInterface::lost_events().
  [[nodiscard]] std::uint64_t lost_events() const;
  /// The functions whose values pass through the codec, since the two ends have other layouts of
  /// one type, or one end has only bytes. Slower, and no longer free of allocations.
  [[nodiscard]] const std::vector<std::string>& converted() const { return converted_; }

 private:
  Connection(RequiredInterface& required, ProvidedInterface& provided, std::string client);
  static Mailbox::SlotShape CommandShape(const RequiredInterface& required,
                                         const ProvidedInterface& provided);
  static Mailbox::SlotShape EventShape(const RequiredInterface& required);
  void OpenMailboxes();
  void BindFunctions();
  void BindHandlers();
  /// Whether the component that requires is told in the thread that changes the connection.
  [[nodiscard]] bool is_told_here() const {
    return required_.inbox() == nullptr && required_.has_hearer();
  }
  void TellClientGone(std::uint64_t number);

  RequiredInterface& required_;
  ProvidedInterface& provided_;
  std::string client_;
  RequiredInterface::Peer peer_;
  Mailbox* commands_ = nullptr;  // at the server
  Mailbox* events_ = nullptr;    // at the client
  using Commands = std::vector<std::unique_ptr<CommandBase>>;
  Commands functions_;        // bound to commands_
  Commands queued_handlers_;  // bound to events_
  Commands direct_handlers_;
  std::vector<BoundMember> members_;  // by function; one more, so that there is a first
  struct Subscription {
    EventBase* event;
    CommandBase* handler;
  };
  std::vector<Subscription> subscriptions_;
  std::vector<std::string> converted_;
  std::uint64_t lost_before_ = 0;
  const SteadyTime made_ = SteadyClock().Now();
  bool open_ = false;
};

}  // namespace tendon
