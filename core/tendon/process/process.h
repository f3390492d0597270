#pragma once

#include <tendon/manager/local_manager.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

class ComponentLoader;
struct ComponentProxy;

inline constexpr std::uint16_t kDefaultGcmPort = 10705;

/// The network settings of a process. Tcp() and Ice() fill in the middleware.
struct ProcessOptions {
  std::shared_ptr<Middleware> middleware;
  std::string gcm;                     ///< "host" or "host:port" of the GCM; empty: joins none
  std::string listen = "127.0.0.1:0";  ///< where peers and viewers connect; port 0 takes a free one
  /// The address for others, if not `listen`: "host:port", or a host to keep the port. A process
  /// that listens at every address announces by default the one from which it reaches the GCM.
  std::string advertise;
  bool retry = true;  ///< tries again until it finds the GCM
  /// Loads plug-ins for orders that come through the GCM; do not use it elsewhere meanwhile. Null:
  /// such orders are refused.
  std::shared_ptr<ComponentLoader> loader{};
};

/// A local component manager with a network. It joins a GCM under its name. Its components can be
/// connected to those of any other process, which makes no difference to them.
///
/// Connections within the process are those of LocalManager. Other connections belong to the
/// process of the required interface. Such a connection is pending while the other process is
/// absent, and is made again whenever that returns. A killed GCM disturbs no connection.
///
/// Log records also go to the GCM, as many of each source as LogLimiter admits. The GCM can set the
/// log level.
///
/// Through the GCM, its components can be started, suspended and stopped. With a loader in the
/// options, components of plug-ins can also be created and removed.
///
/// Thread safety: as LocalManager. Threads: five of its own, one for each order that is under way,
/// and the middleware's.
class Process final : public LocalManager {
 public:
  /// Listens, and starts to join the GCM. Throws ConfigurationError: for a bad name or address;
  /// kExists if the port is in use; kDenied off this machine, or without the user's cookie.
  Process(std::string name, ProcessOptions options);
  /// Stops all components in order, as LocalManager does, while their connections are open and
  /// servers in other processes execute the last calls. Then leaves the GCM and closes all. A peer
  /// or GCM that hangs delays this by at most 2 s.
  ~Process() override;

  [[nodiscard]] const std::string& name() const;
  /// The address for others. Known only after joining if the process listens at every address.
  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::uint64_t instance() const;

  /// Errors: kUnreachable "no GCM at ...", kExists with the holder of the name, kTimeout. The
  /// process works without a GCM, and keeps trying if its options say so.
  Result<void> WaitUntilJoined(std::chrono::milliseconds timeout) const;
  [[nodiscard]] bool is_joined() const;

  /// An end without a process name is in this process. The required interface must be here. The
  /// provided one may be anywhere; if its process or component is absent, the connection is
  /// pending. Blocks for at most two seconds. If the GCM has already ordered the same connection,
  /// as it does for a process that returns, takes that over. Otherwise as LocalManager::Connect().
  Result<ConnectionId> Connect(const InterfaceName& required,
                               const InterfaceName& provided) override;
  Result<void> Disconnect(const InterfaceName& required) override;

  [[nodiscard]] Result<ConnectionCounts> Counts(const InterfaceName& required) const override;

  /// All connections of this process, also pending and failed ones. Both ends have process names.
  [[nodiscard]] std::vector<ConnectionDescription> connections() const override;

  /// The proxies here for components of other processes.
  [[nodiscard]] std::vector<ComponentProxy> proxies() const;

 private:
  class Parts;

  Result<ConnectionId> ConnectAnew(const InterfaceName& required, const InterfaceName& provided);
  void OnRemoving(const Component& component) override;
  [[nodiscard]] bool HasCallsUnderWay(const Component& client) const override;
  [[nodiscard]] InterfaceName Full(InterfaceName name) const;
  [[nodiscard]] Result<InterfaceName> Here(const InterfaceName& required) const;

  std::unique_ptr<Parts> parts_;
};

/// A process that talks over plain sockets: Process process("ui", Tcp({.gcm = "192.168.0.101"})).
/// Addresses off this machine need Exposure::kInsecure, because nothing is encrypted.
ProcessOptions Tcp(ProcessOptions options, Exposure exposure = Exposure::kLoopbackOnly);

}  // namespace tendon
