#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/interface/provided_interface.h>
#include <tendon/interface/required_interface.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// The error for a required interface that is already connected.
[[nodiscard]] Error AlreadyConnected(const std::string& required_name);

/// Connects a required interface to a provided one in the same process. The connection has a
/// mailbox for calls, a mailbox for events, and the bound commands. It lasts until this object is
/// destroyed.
///
/// For managers; one thread at a time. Both components may run during all functions.
class Connection {
 public:
  /// Binds all functions and handlers, or none. Fails with kIncompatible if the interfaces do not
  /// fit (the message names both ends), or if a task would wait for itself. Fails with kExists if
  /// `required` is already connected. Both interfaces must outlive the connection.
  /// Component::OnConnected() runs before the functions reach the peer. It runs in the thread of
  /// the component of `required`, or in the calling thread if that component has no thread.
  static Result<std::unique_ptr<Connection>> Make(RequiredInterface& required,
                                                  ProvidedInterface& provided,
                                                  const std::string& required_name,
                                                  const std::string& provided_name);

  /// Size in bytes of the mailbox slots that Make() allocates.
  [[nodiscard]] static std::size_t MailboxBytes(const RequiredInterface& required,
                                                const ProvidedInterface& provided);

  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  /// Calls Close() with the timeout 0 if the connection is still open.
  ~Connection();

  /// Refuses new calls and events, and gives both ends at most `timeout` to execute the accepted
  /// ones. After that, callers that still wait get kNotConnected, and all data is freed. If a
  /// handler has not returned, its data is freed when it returns. Returns the number of accepted
  /// calls and events that were dropped.
  ///
  /// Component::OnDisconnected() and OnClientGone() run in the components' own threads. If the
  /// component of `required` has no thread, OnDisconnected() runs in the calling thread, before
  /// everything else. Never call Close() from a thread that executes a mailbox of either end.
  std::size_t Close(std::chrono::milliseconds timeout);

  /// The time when the connection was made.
  [[nodiscard]] SteadyTime made() const { return made_; }
  /// Number of calls taken from the server's mailbox, plus events taken from the client's mailbox.
  /// Reads use no mailbox and are not counted.
  [[nodiscard]] std::uint64_t taken() const;
  /// Capacity of the server's mailbox, in calls; 0 if calls are not queued.
  [[nodiscard]] std::size_t capacity() const;
  /// Number of calls in the server's mailbox now.
  [[nodiscard]] std::size_t waiting() const;
  /// Number of calls that were refused because the server's mailbox was full.
  [[nodiscard]] std::uint64_t refused() const;
  /// Number of calls that were replaced by newer ones, because the command keeps only the latest
  /// call.
  [[nodiscard]] std::uint64_t replaced() const;
  /// Number of events that did not reach the client; see RequiredInterface::lost_events().
  [[nodiscard]] std::uint64_t lost_events() const;
  /// The functions whose values pass through the codec, because the two ends have different layouts
  /// of one type, or one end has only bytes. Such calls are slower and may allocate.
  [[nodiscard]] const std::vector<std::string>& converted() const { return converted_; }

 private:
  Connection(RequiredInterface& required, ProvidedInterface& provided, std::string client);
  static Mailbox::SlotShape CommandShape(const RequiredInterface& required,
                                         const ProvidedInterface& provided);
  static Mailbox::SlotShape EventShape(const RequiredInterface& required);
  void OpenMailboxes();
  void BindFunctions();
  void BindHandlers();
  /// True if the component of `required` has no thread, so that OnConnected() and OnDisconnected()
  /// run in the thread that changes the connection.
  [[nodiscard]] bool is_notified_here() const {
    return required_.inbox() == nullptr && required_.has_listener();
  }
  void ReportClientGone(std::uint64_t number);

  RequiredInterface& required_;
  ProvidedInterface& provided_;
  std::shared_ptr<const std::string> client_;
  RequiredInterface::Peer peer_;
  Mailbox* commands_ = nullptr;  // queue at the server
  Mailbox* events_ = nullptr;    // queue at the client
  using Commands = std::vector<std::unique_ptr<CommandBase>>;
  Commands functions_;        // bound to commands_
  Commands queued_handlers_;  // bound to events_
  Commands direct_handlers_;
  std::vector<BoundMember> members_;  // one per function plus one, so never empty
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
