#pragma once

#include <tendon/manager/local_manager.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/context.h>
#include <tendon/proxy/component_proxy.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

class ComponentLoader;

inline constexpr std::uint16_t kDefaultGcmPort = 10705;

/// How a process takes part in the network. Tcp() and Ice() fill in the middleware.
struct ProcessOptions {
  std::shared_ptr<Middleware> middleware;
  std::string gcm;                     ///< "host" or "host:port"; empty: joins none
  std::string listen = "127.0.0.1:0";  ///< for peers and viewers; port 0 takes a free one
  /// Where others reach it, if not where it listens: "host:port", or a host alone for the port at
  /// which it listens. Where it listens at every address: that from which it reaches the GCM.
  std::string advertise;
  bool retry = true;  ///< looks for the GCM until it is found
  /// For those who order components from afar, through the GCM; nobody else uses it meanwhile.
  /// Null: none are made.
  std::shared_ptr<ComponentLoader> loader{};
};

/// A local component manager with a network: it joins a GCM under its name, and its components can
/// be connected to those of any other process, which makes no difference to them.
///
/// Where both ends are here, connections are those of LocalManager. It belongs to the process of
/// the required interface otherwise; while the other process is not there it is pending, and it is
/// made again whenever that returns. Killing the GCM disturbs no connection.
///
/// What its program logs goes to the GCM, too, which may be asked to set the level: so many records
/// of each source as LogLimiter lets through.
///
/// Through the GCM, its components can be started, suspended and stopped; those of plug-ins also be
/// made and removed, where its options have a loader.
///
/// Thread safety: as LocalManager. Threads: five of its own, one for each order from afar that is
/// under way, and the middleware's.
class Process final : public LocalManager, private ProcessHost {
 public:
  /// Listens, and begins to join the GCM. ConfigurationError: a bad name or address; kExists where
  /// the port is in use; kDenied off this machine, or without the user's cookie.
  Process(std::string name, ProcessOptions options);
  /// Stops everything in order, as LocalManager does, while its connections stand and its servers
  /// in other processes execute what it has sent last; then says good-bye, disconnects and destroys
  /// it. A peer, or a GCM, that hangs delays that to 2 s at most.
  ~Process() override;

  [[nodiscard]] const std::string& name() const;
  /// Where others reach it. Of one that listens at every address it is known once it has joined.
  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::uint64_t instance() const;

  /// Errors: kUnreachable "no GCM at ...", kExists with who holds the name, kTimeout. The process
  /// works all the same, and goes on trying if its options say so.
  Result<void> WaitUntilJoined(std::chrono::milliseconds timeout) const;
  [[nodiscard]] bool is_joined() const;

  /// An end without a process means this one. The required interface must be here; the provided one
  /// may be anywhere: where its process, or its component, is not there yet, the connection is
  /// pending. Blocks for at most two seconds. A connection of the two that the GCM ordered, as it
  /// does for a process that returns, is this one. Otherwise as LocalManager::Connect().
  Result<ConnectionId> Connect(const InterfaceName& required,
                               const InterfaceName& provided) override;
  Result<void> Disconnect(const InterfaceName& required) override;

  [[nodiscard]] Result<ConnectionCounts> Counts(const InterfaceName& required) const override;

  /// All of this process, with its name in both ends, also the pending and failed ones.
  [[nodiscard]] std::vector<ConnectionDescription> connections() const override;

  /// What stands in here for components of other processes.
  [[nodiscard]] std::vector<ComponentProxy> proxies() const;

 private:
  class Parts;

  Result<ConnectionId> ConnectAnew(const InterfaceName& required, const InterfaceName& provided);
  void OnRemoving(const Component& component) override;
  [[nodiscard]] bool HasCallsUnderWay(const Component& client) const override;
  [[nodiscard]] InterfaceName Full(InterfaceName name) const;
  [[nodiscard]] Result<InterfaceName> Here(const InterfaceName& required) const;

  std::unique_lock<std::recursive_mutex> LockStructure() const override { return Lock(); }
  Result<RequiredInterface*> LookUpRequired(const InterfaceName& name) const override;
  Result<ProvidedInterface*> LookUpProvided(const InterfaceName& name) const override;
  Component* LookUpComponent(const std::string& component) const override;
  Result<ConnectionCounts> LookUpCounts(const InterfaceName& required) const override;
  Result<MailboxFill> LookUpFill(const std::string& component) const override;
  ConnectionId NewConnectionId() override { return NextConnectionId(); }
  void StructureChanged() const override { NotifyChanged(); }

  std::unique_ptr<Parts> parts_;
};

/// Processes that talk over plain sockets: Process process("ui", Tcp({.gcm = "192.168.0.101"})).
/// Addresses off this machine need Exposure::kInsecure, for nothing is encrypted.
ProcessOptions Tcp(ProcessOptions options, Exposure exposure = Exposure::kLoopbackOnly);

}  // namespace tendon
