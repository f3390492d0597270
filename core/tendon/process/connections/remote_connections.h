#pragma once

#include <tendon/base/backoff.h>
#include <tendon/interface/connection.h>
#include <tendon/process/connections/peer_links.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// The connections from required interfaces of this process to provided interfaces of other
/// processes. A connection is active, pending or refused. A lost connection is made again when its
/// peer returns; interrupted calls are not repeated.
///
/// Functions are called on the worker unless noted.
class RemoteConnections final : private PeerListener {
 public:
  using Done = std::function<void(const Result<ConnectionDescription>&)>;

  explicit RemoteConnections(ProcessContext& context) : context_(context), peers_(context, *this) {}

  /// Adds the connection, and calls `done` when it is active or pending. After an error, the
  /// connection is not added. Errors: kNotFound if this process has no such required interface,
  /// kExists, kIncompatible. All names include the process.
  void Connect(const message::ConnectionEnds& ends, Done done);

  /// Sets the present processes, and opens the connections that are now possible.
  void UpdatePeers(const std::vector<ProcessDescription>& processes);
  void LearnPeer(const std::string& process, const std::string& address, std::uint64_t instance);

  // Any thread.

  [[nodiscard]] bool Has(const InterfaceName& required) const;
  /// Sends the accepted calls, then removes the connection.
  Result<void> Disconnect(const InterfaceName& required);
  /// Removes all connections of a component. Call it before the component is removed.
  void RemoveComponent(const std::string& component);
  [[nodiscard]] std::vector<ConnectionDescription> descriptions() const;
  /// Returns the counts of a connection. If the connection is not active, returns kFailed with the
  /// reason and the time.
  [[nodiscard]] Result<ConnectionCounts> Counts(const InterfaceName& required) const;

  /// True if servers may still execute accepted calls of the component.
  [[nodiscard]] bool HasCallsUnderWay(const std::string& component) const;

  /// Sends the accepted calls, at most until `deadline`, and ends all connections. Call it after
  /// the worker has stopped.
  void Close(SteadyTime deadline);

 private:
  struct Entry {
    ConnectionDescription description;
    SteadyTime since{};            // start of the time without a connection
    Done done;                     // callback of Connect(); empty after the first outcome
    std::uint64_t attempt = 0;     // the newest attempt; outcomes of earlier attempts are
                                   // ignored
    bool is_opening = false;       // true until the attempt has an outcome
    std::uint64_t refused_by = 0;  // instance of the process that has refused the connection
    Backoff backoff = kLinkRetry;
    std::shared_ptr<PeerLink> link;
    std::uint32_t handle = 0;  // the number that this end has issued
    std::shared_ptr<ProvidedInterfaceProxy> proxy;
    std::unique_ptr<Connection> connection;
  };
  using Entries = std::map<ConnectionId, Entry>;

  /// An attempt whose request was sent.
  struct Attempt {
    ConnectionId id = 0;
    std::uint64_t number = 0;
    std::shared_ptr<PeerLink> link;
    std::uint32_t handle = 0;
  };

  void OnLinkClosed(const PeerLink& link, const Error& reason) override;
  void OnInterfaceClosed(const PeerLink& link, std::uint32_t handle, const Error& reason) override;
  void OnServerChanged() override { context_.process.StructureChanged(); }

  Result<ConnectionId> Enter(const message::ConnectionEnds& ends, const Done& done);
  void TryPossible();
  void Try(ConnectionId id);
  void ReportPending(ConnectionId id, std::uint64_t attempt);
  void Request(ConnectionId id, const std::shared_ptr<PeerLink>& link);
  void GiveUp(ConnectionId id, std::uint64_t attempt, const Error& reason);
  void Finish(const Attempt& attempt, const OpenedInterface& opened);
  Result<void> Bind(Entry& entry, const std::shared_ptr<ProvidedInterfaceProxy>& proxy);
  void Postpone(ConnectionId id, const std::string& reason);
  void Refuse(ConnectionId id, const Error& error);
  void Suspend(Entry& entry, const std::string& reason);
  void TakeDown(Entry& entry, SteadyTime deadline);
  void CloseThere(const std::shared_ptr<Channel>& channel, std::uint32_t handle, Lane lane);
  [[nodiscard]] bool IsNewest(ConnectionId id, std::uint64_t attempt) const;
  [[nodiscard]] Entries::const_iterator FindEntry(const InterfaceName& required) const;

  ProcessContext& context_;
  PeerLinks peers_;
  Entries entries_;  // protected by the manager's lock
};

}  // namespace tendon
