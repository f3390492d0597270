#pragma once

#include <tendon/manager/local_manager.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/worker.h>
#include <tendon/proxy/component_proxy.h>
#include <tendon/proxy/network_thread.h>
#include <tendon/proxy/threads/call_threads.h>

#include <memory>
#include <mutex>
#include <string>

namespace tendon {

/// The components of a process as its network parts reach them.
class ProcessHost {
 public:
  virtual ~ProcessHost() = default;
  /// The manager's lock: held while components are looked up and connections made or broken.
  [[nodiscard]] virtual std::unique_lock<std::recursive_mutex> LockStructure() const = 0;
  // With the lock held, and valid as long.
  [[nodiscard]] virtual Result<RequiredInterface*> LookUpRequired(const InterfaceName&) const = 0;
  [[nodiscard]] virtual Result<ProvidedInterface*> LookUpProvided(const InterfaceName&) const = 0;
  [[nodiscard]] virtual Component* LookUpComponent(const std::string& name) const = 0;
  virtual ConnectionId NewConnectionId() = 0;
  // Any thread.
  /// Of one of this process, or of another one that is served here.
  [[nodiscard]] virtual Result<ConnectionCounts> LookUpCounts(const InterfaceName&) const = 0;
  [[nodiscard]] virtual Result<MailboxFill> LookUpFill(const std::string& component) const = 0;
  /// A connection has changed.
  virtual void StructureChanged() const = 0;
};

/// What the network parts of one process have in common. It outlives them.
///
/// Threads: the structure (which connections there are, to what) is changed on the worker, or under
/// the manager's lock by who removes a component or disconnects; threads of the middleware post to
/// the worker what might block. It waits for no other process: links are opened by the openers,
/// which post to the worker what has come of it.
struct ProcessContext {
  std::string name;
  ProcessHost& host;
  std::shared_ptr<Middleware> middleware;
  Hello hello;  ///< of channels that are opened; its session belongs to the worker
  std::shared_ptr<Worker> worker;
  std::shared_ptr<Worker> opener;      ///< of links to peers
  std::shared_ptr<Worker> gcm_opener;  ///< of that to the GCM, which no peer that hangs delays
  std::shared_ptr<NetworkThread> network;
  std::shared_ptr<SortsOfCalls> calls;
  ComponentProxies proxies;
};

}  // namespace tendon
