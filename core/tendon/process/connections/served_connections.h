#pragma once

#include <tendon/interface/connection.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/audit_log.h>
#include <tendon/process/context.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/proxy/handle_table.h>
#include <tendon/proxy/required_interface_proxy.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>

namespace tendon {

/// Another process that has opened a channel to this one, and the handles issued to it.
struct Client {
  std::shared_ptr<Channel> channel;
  AuditLog audit;  ///< for the connections of this client
  HandleTable<RequiredInterfaceProxy> handles;
};

/// Returns "robot/arm/Control for desk/operator/Robot", for the audit log.
[[nodiscard]] std::string EndsOf(const message::OpenInterface& open);

/// The connections from required interfaces of other processes to provided interfaces of this
/// process. The audit log gets a line when a connection that may transmit commands is opened, and a
/// line with the number of commands when it is closed.
///
/// Functions are called on the worker unless noted.
class ServedConnections {
 public:
  explicit ServedConnections(ProcessContext& context) : context_(context) {}

  /// kEventsOnly is for a client that only listens to events and to calls of commands. This client
  /// may be a viewer. The number of these connections is limited, for each client and in total.
  /// Closing one of them does not wait until the client has received all events.
  enum class Use { kAll, kEventsOnly };
  static constexpr std::ptrdiff_t kMaxListenersOfOne = 128;
  static constexpr std::ptrdiff_t kMaxListeners = 512;

  /// Makes the connection. Replies before it sends other messages of the connection. Refusals:
  /// kNotFound with a suggestion, kIncompatible with the first difference, kInvalid for a mailbox
  /// that is too large, kFailed for too many listeners.
  void Open(const std::shared_ptr<Client>& client, const message::OpenInterface& open, Use use,
            const std::shared_ptr<Responder>& responder);
  /// Executes the calls that have arrived, then closes the connection. `handle` is the number that
  /// this end has issued. If a call hangs in component code, no thread waits for it; the connection
  /// is freed when the call returns.
  void Close(const std::shared_ptr<Client>& client, std::uint32_t handle);
  /// Closes all connections of a client that has disconnected, in the same way.
  void CloseAll(const std::shared_ptr<Client>& client);

  /// Closes all connections to a component. Notifies clients and waits for hanging calls. Call it
  /// before the component is removed. Any thread.
  void RemoveComponent(const std::string& component);
  /// True if all events that were raised so far have been sent. Any thread.
  [[nodiscard]] bool HasSentAllEvents() const;
  /// Closes all connections. Call it after the worker has stopped and all channels are closed.
  /// Waits for running calls until `deadline`, and longer only for calls that must not be
  /// abandoned.
  void Close(SteadyTime deadline);

 private:
  struct Entry {
    std::shared_ptr<Client> client;
    InterfaceName required;
    std::string component;
    std::string ends;
    Use use = Use::kAll;
    std::uint32_t handle = 0;
    std::shared_ptr<RequiredInterfaceProxy> proxy;
    std::unique_ptr<Connection> connection;
  };

  Result<ProvidedInterface*> LookUp(const InterfaceName& provided) const;
  [[nodiscard]] Result<void> CheckListeners(const Client& client, Use use) const;
  static Result<void> CheckSize(const message::OpenInterface& open, Use use, std::size_t bytes);
  Result<Entry> Make(const std::shared_ptr<Client>& client, const message::OpenInterface& open,
                     Use use, ProvidedInterface& provided);
  static void Detach(Entry& entry);
  void TakeDown(Entry& entry, SteadyTime deadline);
  /// Closes and removes the entries for which `predicate` returns true.
  template <typename Predicate>
  void TakeDownWhere(std::list<Entry>& entries, Predicate predicate, SteadyTime deadline);
  void CheckHanging();
  /// Writes a line to the audit log if commands may come over the connection.
  static void LogChange(const Entry& entry, const std::string& what);
  template <typename Predicate>
  void CloseWhere(Predicate predicate);

  ProcessContext& context_;
  std::list<Entry> entries_;  // guarded by the manager's lock
  std::list<Entry> hanging_;  // closed entries with a call that has not returned
};

}  // namespace tendon
