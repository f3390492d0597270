#pragma once

#include <tendon/manager/local_manager.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/worker.h>
#include <tendon/proxy/component_proxy.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/worker_pool.h>

#include <memory>
#include <mutex>
#include <string>

namespace tendon {

/// Gives the network parts access to their process.
class ProcessAccess {
 public:
  virtual ~ProcessAccess() = default;
  /// Takes the manager's lock. Hold the lock while you look up components, and while you make or
  /// end connections.
  [[nodiscard]] virtual std::unique_lock<std::recursive_mutex> LockStructure() const = 0;
  // Call these with the lock held; the results are valid as long as the lock is held.
  [[nodiscard]] virtual Result<RequiredInterface*> LookUpRequired(const InterfaceName&) const = 0;
  [[nodiscard]] virtual Result<ProvidedInterface*> LookUpProvided(const InterfaceName&) const = 0;
  [[nodiscard]] virtual Component* LookUpComponent(const std::string& name) const = 0;
  virtual ConnectionId NewConnectionId() = 0;
  // Any thread.
  /// Returns the counts of a connection that this process has made, or that another process has
  /// made to this process.
  [[nodiscard]] virtual Result<ConnectionCounts> LookUpCounts(const InterfaceName&) const = 0;
  [[nodiscard]] virtual Result<MailboxFill> LookUpFill(const std::string& component) const = 0;
  /// Call it when a connection has changed.
  virtual void StructureChanged() const = 0;
};

/// The data that the network parts of one process share. It outlives these parts.
///
/// Threads: the worker changes the connections. A thread that removes a component or disconnects
/// also changes them, under the manager's lock. Threads of the middleware post all work that might
/// block to the worker. The worker never waits for another process: the openers open links, and
/// post the results to the worker.
struct ProcessContext {
  std::string name;
  ProcessAccess& process;
  std::shared_ptr<Middleware> middleware;
  Hello hello;  ///< for channels that this process opens; only the worker changes it
  std::shared_ptr<Worker> worker;
  std::shared_ptr<Worker> opener;      ///< opens links to peers
  std::shared_ptr<Worker> gcm_opener;  ///< opens the link to the GCM, so that no peer delays it
  std::shared_ptr<NetworkThread> network;
  std::shared_ptr<CallExecutors> calls;
  ComponentProxies proxies;
};

}  // namespace tendon
