#pragma once

#include <tendon/base/name.h>
#include <tendon/proxy/provided_interface_proxy.h>
#include <tendon/proxy/required_interface_proxy.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// Stands in, in this process, for a component of another one. It holds those of its interfaces to
/// which there are connections here, one proxy a connection, and lives as long as there is one.
/// Unlike a component it has no life of its own, and a manager does not list it.
struct ComponentProxy {
  std::string process;
  std::string component;
  std::vector<std::shared_ptr<ProvidedInterfaceProxy>> provided;
  std::vector<std::shared_ptr<RequiredInterfaceProxy>> required;
};

/// All component proxies of one process. Takes the interfaces' proxies in and has the network
/// thread work for them, until they are removed. Thread-safe.
class ComponentProxies {
 public:
  explicit ComponentProxies(std::shared_ptr<NetworkThread> thread) : thread_(std::move(thread)) {}
  ComponentProxies(const ComponentProxies&) = delete;
  ComponentProxies& operator=(const ComponentProxies&) = delete;

  /// `original` is the interface in the other process. Who hears what the proxy sends finds it in
  /// all() already.
  void Add(const InterfaceName& original, std::shared_ptr<ProvidedInterfaceProxy> proxy);
  void Add(const InterfaceName& original, std::shared_ptr<RequiredInterfaceProxy> proxy);
  /// After it returns the network thread does not work for the proxy any more.
  void Remove(const InterfaceName& original, ProvidedInterfaceProxy& proxy);
  void Remove(const InterfaceName& original, RequiredInterfaceProxy& proxy);

  /// As they are now, by name.
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
