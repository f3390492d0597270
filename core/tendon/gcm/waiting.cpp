#include <tendon/gcm/waiting.h>

#include <tendon/gcm/lookup.h>

namespace tendon {
namespace {

FindConnection ConnectionsOf(const ProcessEntry& process, const ComponentDescription& component) {
  return [&process, &component](const std::string& interface) -> const ConnectionDescription* {
    for (const auto& [id, connection] : process.connections) {
      const InterfaceName& required = connection.required;
      const bool is_meant = required.component == component.name && required.interface == interface;
      if (is_meant) return &connection;
    }
    return nullptr;
  };
}

}  // namespace

std::vector<UnsatisfiedInterface> WaitsOf(const ProcessEntry& process,
                                          const ComponentDescription& component,
                                          const FindConnection& find) {
  const bool runs = IsPresent(process.process) && IsRunning(component.state);
  return runs ? UnmetNeedsOf(component, find) : std::vector<UnsatisfiedInterface>();
}

std::vector<UnsatisfiedInterface> WaitsOf(const ProcessEntry& process,
                                          const ComponentDescription& component) {
  return WaitsOf(process, component, ConnectionsOf(process, component));
}

std::vector<UnsatisfiedInterface> UnmetNeedsOf(const ProcessEntry& process,
                                               const ComponentDescription& component) {
  return UnmetNeedsOf(component, ConnectionsOf(process, component));
}

std::string WaitingText(const std::vector<UnsatisfiedInterface>& waits) {
  return waits.empty() ? "" : "waiting for " + NamesOf(waits);
}

std::string WaitingReasons(const std::vector<UnsatisfiedInterface>& waits) {
  return waits.empty() ? "" : "waiting for " + ReasonsOf(waits);
}

std::string StateText(const ProcessEntry& process, const ComponentDescription& component) {
  const std::string waiting = WaitingText(WaitsOf(process, component));
  return std::string(ToString(component.state)) + (waiting.empty() ? "" : ", " + waiting);
}

}  // namespace tendon
