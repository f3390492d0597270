#pragma once

#include <tendon/interface/connection.h>
#include <tendon/process/client/interface_opening.h>
#include <tendon/process/client/peers.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// The connections of this process' required interfaces to provided interfaces elsewhere: those
/// that stand, those that wait for the other process, those that it refused. One that was lost is
/// made again when its peer is there again; nothing that was under way is repeated.
///
/// Without a remark, functions are called on the worker.
class RemoteConnections final : private PeerListener {
 public:
  using Done = std::function<void(const Result<ConnectionDescription>&)>;

  explicit RemoteConnections(ProcessContext& context) : context_(context), peers_(context, *this) {}

  /// Wants the connection from now on, and says when it stands or waits. It is not wanted after an
  /// error: kNotFound for our end, kExists, kIncompatible. All ends are named with their processes.
  void Connect(const message::Wire& wire, Done done);

  /// Which processes there are: makes what can be made.
  void UpdatePeers(const std::vector<ProcessDescription>& processes);
  void LearnPeer(const std::string& process, const std::string& address, std::uint64_t instance);

  // Any thread.

  [[nodiscard]] bool Has(const InterfaceName& required) const;
  /// Ends and forgets it; what was accepted is sent first.
  Result<void> Disconnect(const InterfaceName& required);
  /// Before the component goes.
  void RemoveComponent(const std::string& component);
  [[nodiscard]] std::vector<ConnectionDescription> descriptions() const;
  /// kFailed where it does not stand: why, and for how long.
  [[nodiscard]] Result<ConnectionCounts> Counts(const InterfaceName& required) const;

  /// Whether calls of the component were accepted that its servers may still execute.
  [[nodiscard]] bool HasCallsUnderWay(const std::string& component) const;

  /// Once the worker has stopped: ends all. What was accepted is sent until `deadline`.
  void Close(SteadyTime deadline);

 private:
  struct Entry {
    ConnectionDescription description;
    SteadyTime since{};                  // it does not stand
    Done done;                           // of Connect(), until the first outcome
    std::uint64_t attempt = 0;           // the newest; outcomes of earlier ones are void
    bool is_opening = false;             // and its outcome is still to come
    std::uint64_t refused_by = 0;        // the instance that refused it
    std::chrono::milliseconds pause{0};  // before the next attempt
    std::shared_ptr<PeerLink> link;
    std::uint32_t handle = 0;  // our number on the link
    std::shared_ptr<ProvidedInterfaceProxy> proxy;
    std::unique_ptr<Connection> connection;
  };
  using Entries = std::map<ConnectionId, Entry>;

  /// An attempt that has been sent.
  struct Attempt {
    ConnectionId id = 0;
    std::uint64_t number = 0;
    std::shared_ptr<PeerLink> link;
    std::uint32_t handle = 0;
  };

  void OnLinkClosed(const PeerLink& link, const Error& reason) override;
  void OnInterfaceClosed(const PeerLink& link, std::uint32_t handle, const Error& reason) override;
  void OnServerChanged() override { context_.host.StructureChanged(); }

  Result<ConnectionId> Enter(const message::Wire& wire, const Done& done);
  void TryPossible();
  void Try(ConnectionId id);
  void TellWaiting(ConnectionId id, std::uint64_t attempt);
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
  Peers peers_;
  Entries entries_;  // under the manager's lock
};

}  // namespace tendon
