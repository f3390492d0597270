#pragma once

#include <tendon/base/name.h>
#include <tendon/proxy/provided_interface_proxy.h>
#include <tendon/proxy/required_interface_proxy.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// Represents a component of another process in this process. It has one proxy for each connection
/// between this process and an interface of the component, and exists as long as there is such a
/// connection. Unlike a component, it has no lifecycle, and managers do not list it.
struct ComponentProxy {
  std::string process;
  std::string component;
  std::vector<std::shared_ptr<ProvidedInterfaceProxy>> provided;
  std::vector<std::shared_ptr<RequiredInterfaceProxy>> required;
};

/// All component proxies of one process. An added interface proxy also becomes a job of the network
/// thread, until it is removed. Thread-safe.
class ComponentProxies {
 public:
  explicit ComponentProxies(std::shared_ptr<NetworkThread> thread) : thread_(std::move(thread)) {}
  ComponentProxies(const ComponentProxies&) = delete;
  ComponentProxies& operator=(const ComponentProxies&) = delete;

  /// Adds a proxy. `original` is the name of the interface in the other process. all() contains the
  /// proxy before the proxy sends its first message.
  void Add(const InterfaceName& original, std::shared_ptr<ProvidedInterfaceProxy> proxy);
  void Add(const InterfaceName& original, std::shared_ptr<RequiredInterfaceProxy> proxy);
  /// Removes a proxy. After the return, the network thread does not use it any more.
  void Remove(const InterfaceName& original, ProvidedInterfaceProxy& proxy);
  void Remove(const InterfaceName& original, RequiredInterfaceProxy& proxy);

  /// The current component proxies, by name.
  [[nodiscard]] std::vector<ComponentProxy> all() const;

 private:
  using Key = std::pair<std::string, std::string>;

  ComponentProxy& Of(const InterfaceName& original);
  void RemoveIfEmpty(const InterfaceName& original);

  const std::shared_ptr<NetworkThread> thread_;
  mutable std::mutex mutex_;
  std::map<Key, ComponentProxy> proxies_;
};

}  // namespace tendon
