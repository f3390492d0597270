#include <tendon/proxy/component_proxy.h>

namespace tendon {
namespace {

template <typename Proxy>
void Erase(std::vector<std::shared_ptr<Proxy>>& proxies, const Proxy& proxy) {
  std::erase_if(proxies, [&proxy](const auto& one) { return one.get() == &proxy; });
}

}  // namespace

void ComponentProxies::Add(const InterfaceName& original,
                           std::shared_ptr<ProvidedInterfaceProxy> proxy) {
  {
    const std::scoped_lock lock(mutex_);
    Of(original).provided.push_back(proxy);
  }
  thread_->Add(*proxy);
}

void ComponentProxies::Add(const InterfaceName& original,
                           std::shared_ptr<RequiredInterfaceProxy> proxy) {
  {
    const std::scoped_lock lock(mutex_);
    Of(original).required.push_back(proxy);
  }
  thread_->Add(*proxy);
}

void ComponentProxies::Remove(const InterfaceName& original, ProvidedInterfaceProxy& proxy) {
  thread_->Remove(proxy);
  const std::scoped_lock lock(mutex_);
  Erase(Of(original).provided, proxy);
  RemoveIfEmpty(original);
}

void ComponentProxies::Remove(const InterfaceName& original, RequiredInterfaceProxy& proxy) {
  thread_->Remove(proxy);
  const std::scoped_lock lock(mutex_);
  Erase(Of(original).required, proxy);
  RemoveIfEmpty(original);
}

std::vector<ComponentProxy> ComponentProxies::all() const {
  const std::scoped_lock lock(mutex_);
  std::vector<ComponentProxy> all;
  for (const auto& [key, proxy] : proxies_) all.push_back(proxy);
  return all;
}

ComponentProxy& ComponentProxies::Of(const InterfaceName& original) {
  ComponentProxy& proxy = proxies_[{original.process, original.component}];
  proxy.process = original.process;
  proxy.component = original.component;
  return proxy;
}

void ComponentProxies::RemoveIfEmpty(const InterfaceName& original) {
  const auto found = proxies_.find({original.process, original.component});
  if (found->second.provided.empty() && found->second.required.empty()) proxies_.erase(found);
}

}  // namespace tendon
