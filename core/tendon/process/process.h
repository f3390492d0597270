#pragma once

#include <tendon/base/log.h>
#include <tendon/manager/local_manager.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

class ComponentLoader;
class LocalAccess;
struct ComponentProxy;

inline constexpr std::uint16_t kDefaultGcmPort = 10705;

/// The limits of the history of a process: rows of its state tables, events and log records.
struct HistoryOptions {
  std::size_t memory = std::size_t{32} << 20U;  ///< bytes at most; 0 keeps nothing
  std::chrono::nanoseconds span = std::chrono::seconds(30);
};

/// The network settings of a process. Tcp() and Ice() fill in the middleware.
struct ProcessOptions {
  std::shared_ptr<Middleware> middleware{};
  std::string gcm{};                   ///< "host" or "host:port" of the GCM; empty: no GCM
  std::string listen = "127.0.0.1:0";  ///< peers and viewers connect here; 0 takes a free port
  /// The address to announce, if it differs from `listen`: "host:port", or only a host with the
  /// port of `listen`. By default, a process that listens at every address announces the address
  /// from which it reaches the GCM.
  std::string advertise{};
  bool retry = true;  ///< true: tries again until it finds the GCM
  /// Loads plug-ins for orders from the GCM. Other code must not use it while the Process object
  /// exists. If null, orders to load plug-ins are refused.
  std::shared_ptr<ComponentLoader> loader{};
  HistoryOptions history{};
};

/// A component manager that is connected to other processes. It joins a GCM under its name. Its
/// components can be connected to components of any other process, in the same way as to local
/// components.
///
/// Connections within the process are handled by LocalManager. A connection to another process
/// belongs to the process of the required interface. It is pending while the other process is
/// absent, and is made again when that process returns. A crash of the GCM does not affect
/// connections.
///
/// A process keeps the last 30 s of its rows, events and log records, in at most 32 MiB, so that
/// they can be saved afterwards; see HistoryOptions.
///
/// Log records are also sent to the GCM, within the limits of LogLimiter for each source. The GCM
/// can set the log level.
///
/// Through the GCM, its components can be started, suspended and stopped. With a loader in the
/// options, components of plug-ins can also be created and removed.
///
/// Thread safety: like LocalManager. A process has six threads of its own, one more for each
/// running order, and the threads of the middleware.
class Process final : public LocalManager {
 public:
  /// Listens, and starts to join the GCM. Throws ConfigurationError if the name or an address is
  /// invalid, if the port is in use (kExists), if an address of another machine is not allowed, or
  /// if the user's cookie cannot be read (kDenied).
  Process(std::string name, ProcessOptions options);
  /// Stops all components in order, as LocalManager does. Their connections stay open, so that
  /// servers in other processes execute the last calls. Then leaves the GCM and closes all
  /// channels. A hanging peer or GCM delays the destructor by at most 2 s.
  ~Process() override;

  [[nodiscard]] const std::string& name() const;
  /// The announced address. If the process listens at every address, the announced address is known
  /// only after joining.
  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::uint64_t instance() const;

  /// Waits until the process has joined the GCM. Fails with kUnreachable if there is no GCM, with
  /// kExists if another process has the name (the error names that process), and with kTimeout. The
  /// process works without a GCM; it keeps trying to join if ProcessOptions::retry is set.
  Result<void> WaitUntilJoined(std::chrono::milliseconds timeout) const;
  [[nodiscard]] bool is_joined() const;

  /// Sends a record to the GCM as if `source`, a component of this process, had logged it. Used by
  /// replays and by programs with several processes, because Log() sends a record once for each
  /// process of the program.
  void ForwardLog(LogLevel level, std::string_view source, std::string_view text);

  /// True if all rows and events up to now are sent to all viewers and peers. For programs that end
  /// soon. It stays false while a peer does not read, so callers need a time limit.
  [[nodiscard]] bool HasSentAll() const;

  /// Like LocalManager::Connect(), but the provided interface may be in any process. The required
  /// interface must be in this process. A name without a process means this process. Blocks for at
  /// most two seconds.
  ///
  /// If the provider's process or component is absent, the connection is pending. If the GCM has
  /// already ordered the same connection, takes over that connection. The GCM orders connections of
  /// a process that has returned.
  Result<ConnectionId> Connect(const InterfaceName& required,
                               const InterfaceName& provided) override;
  Result<void> Disconnect(const InterfaceName& required) override;

  [[nodiscard]] Result<ConnectionCounts> Counts(const InterfaceName& required) const override;

  /// Returns all connections of this process, including pending and failed ones. The names of both
  /// ends include the process.
  [[nodiscard]] std::vector<ConnectionDescription> connections() const override;

  /// The proxies in this process for components of other processes.
  [[nodiscard]] std::vector<ComponentProxy> proxies() const;

  /// Returns the access for components that use the services of this process without the network.
  /// See process/local_access.h. The services are started by the first call.
  [[nodiscard]] std::shared_ptr<LocalAccess> OpenLocalAccess();

 private:
  class Parts;

  Result<ConnectionId> ConnectAnew(const InterfaceName& required, const InterfaceName& provided);
  void OnAttached(Component& component) override;
  void OnDetached(const Component& component) override;
  void OnRemoving(const Component& component) override;
  [[nodiscard]] bool HasCallsUnderWay(const Component& client) const override;
  [[nodiscard]] InterfaceName Full(InterfaceName name) const;
  [[nodiscard]] Result<InterfaceName> Here(const InterfaceName& required) const;

  std::unique_ptr<Parts> parts_;
};

/// Returns options for a process that uses plain sockets: Process process("ui", Tcp({.gcm =
/// "192.168.0.101"})). Addresses of other machines need Exposure::kInsecure, because the
/// connections are not encrypted.
ProcessOptions Tcp(ProcessOptions options, Exposure exposure = Exposure::kLoopbackOnly);

}  // namespace tendon
