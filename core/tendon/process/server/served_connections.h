#pragma once

#include <tendon/interface/connection.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/access/audit_log.h>
#include <tendon/process/context.h>
#include <tendon/proxy/handle_table.h>
#include <tendon/proxy/messages.h>
#include <tendon/proxy/required_interface_proxy.h>

#include <cstddef>
#include <functional>
#include <list>
#include <memory>
#include <string>

namespace tendon {

/// Another process that has opened a channel to this one, with the numbers issued to it.
struct Client {
  std::shared_ptr<Channel> channel;
  AuditLog audit;  ///< of its connections
  HandleTable<RequiredInterfaceProxy> handles;
};

/// "robot/arm/Control for desk/operator/Robot", for the audit log.
[[nodiscard]] std::string EndsOf(const message::OpenInterface& open);

/// The connections of other processes' required interfaces to provided interfaces here. Of one that
/// may bring commands the audit log says when it stands, and when it ends how many came.
///
/// Without a remark, functions are called on the worker.
class ServedConnections {
 public:
  explicit ServedConnections(ProcessContext& context) : context_(context) {}

  /// Whoever only listens may be a viewer: a client has so many of them at most, all clients
  /// together some more, and nobody waits until one has taken what it was sent. Who knows marks is
  /// answered with a MarkedOpened.
  enum class Use { kAll, kAllMarked, kEventsOnly };
  static constexpr std::ptrdiff_t kMostListenersOfOne = 64;
  static constexpr std::ptrdiff_t kMostListeners = 256;

  /// Connects, and answers before anything else is sent about the connection. Refusals: kNotFound
  /// with a suggestion, kIncompatible with the first difference, kInvalid for a mailbox that is too
  /// large, kFailed for a listener too many.
  void Open(const std::shared_ptr<Client>& client, const message::OpenMarked& wanted, Use use,
            const std::shared_ptr<Responder>& responder);
  /// Executes first what has arrived; `handle` is our number of it. Where a call of it hangs in
  /// code of the component, the connection is freed once that has returned, and nobody waits for
  /// it.
  void Close(const std::shared_ptr<Client>& client, std::uint32_t handle);
  /// All of a client that is gone, likewise.
  void CloseAll(const std::shared_ptr<Client>& client);

  /// Any thread: before the component goes; its clients are told. Waits for calls that hang in it.
  void RemoveComponent(const std::string& component);
  /// Once the worker has stopped and no channel is open. Waits for calls that run no longer than
  /// until `deadline`, as far as they may be left alone.
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
  static Result<void> CheckSize(const message::OpenInterface& open, std::size_t bytes);
  Result<Entry> Make(const std::shared_ptr<Client>& client, const message::OpenMarked& wanted,
                     Use use, ProvidedInterface& provided);
  static void TakeOff(Entry& entry);
  void TakeDown(Entry& entry, SteadyTime deadline);
  /// Those of `entries` that it holds for.
  template <typename Predicate>
  void TakeDownWhere(std::list<Entry>& entries, Predicate predicate, SteadyTime deadline);
  void LookAfterHanging();
  /// In the audit log, where it may bring commands.
  static void WriteDown(const Entry& entry, const std::string& what);
  template <typename Predicate>
  void CloseWhere(Predicate predicate);

  ProcessContext& context_;
  std::list<Entry> entries_;  // under the manager's lock
  std::list<Entry> hanging_;  // likewise: closed, but for a call that has not returned
};

}  // namespace tendon
