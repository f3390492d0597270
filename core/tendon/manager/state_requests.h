#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/manager/component_order.h>
#include <tendon/manager/orderly_shutdown.h>
#include <tendon/manager/request_serializer.h>
#include <tendon/task/component.h>

#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// Requests the components of a manager to change their states, and waits until they do. Only one
/// request at a time is in progress for each component (RequestSerializer). ComponentOrder says in
/// which order several components receive their requests.
///
/// Thread-safe, but no function may be called in a component's own thread. The public functions of
/// LocalManager with the same names say what they promise.
class StateRequests {
 public:
  using ComponentPointer = std::shared_ptr<Component>;
  using IsMeant = std::function<bool(const Component&)>;
  /// The functions of the manager that this class uses.
  struct Manager {
    /// Locks the components of the manager.
    std::function<std::unique_lock<std::recursive_mutex>()> lock;
    std::function<Result<ComponentPointer>(const std::string&)> find;
    std::function<ComponentOrder()> order;
    /// Returns true if calls that the component has sent are not executed yet.
    std::function<bool(const Component&)> has_calls_under_way;
  };

  explicit StateRequests(Manager manager);

  Result<void> Start(const std::string& component, std::chrono::nanoseconds timeout);
  Result<void> Start(const std::string& component, std::chrono::nanoseconds timeout,
                     std::function<bool()> proceed);
  Result<void> Suspend(const std::string& component, std::chrono::nanoseconds timeout);
  Result<void> Stop(const std::string& component, std::chrono::nanoseconds timeout);
  Result<void> TransitionTo(const std::string& component, ComponentState wanted,
                            std::chrono::nanoseconds timeout);
  Result<void> StartAll(std::chrono::nanoseconds timeout);
  Result<void> SuspendAll(std::chrono::nanoseconds timeout);
  Result<void> StopAll(std::chrono::nanoseconds timeout);
  Result<void> WaitFor(const std::string& component, ComponentState state,
                       std::chrono::nanoseconds timeout) const;
  Result<void> WaitForAll(ComponentState state, std::chrono::nanoseconds timeout) const;

  /// Stops the components for which `is_meant` is true, as OrderlyShutdown says.
  Result<void> StopInOrder(const IsMeant& is_meant, SteadyTime deadline);
  /// Waits until no other request for the component is in progress, then requests its stop. Does
  /// not wait until it has stopped.
  Result<void> RequestStop(const ComponentPointer& component, SteadyTime deadline);
  /// Fails with kTimeout if a request is in progress for the component, or for a component that
  /// runs after it. Must be called while the manager is locked.
  [[nodiscard]] Result<void> RequireNoRequest(const Component& component) const;

 private:
  using Components = ComponentOrder::Components;
  using Request = std::function<Result<void>(Component&)>;

  Result<void> RequestState(const std::string& component, const Request& request,
                            ComponentState wanted, std::chrono::nanoseconds timeout);
  Result<void> RequestStateOfAll(const Components& components, const Request& request,
                                 ComponentState wanted, std::chrono::nanoseconds timeout);
  Result<void> MakeRequest(const ComponentPointer& component, const Request& request,
                           SteadyTime deadline);
  [[nodiscard]] bool IsAtRest(const Component& component) const;
  /// Waits until servers have executed the calls of `client`. Logs a warning if this takes longer
  /// than until `deadline`.
  void LetExecute(const Component& client, SteadyTime deadline) const;
  [[nodiscard]] Components StartOrder() const;
  [[nodiscard]] std::vector<OrderlyShutdown::Member> EndOrder(const IsMeant& is_meant) const;

  const Manager manager_;
  RequestSerializer serializer_;  // guarded by the lock of the manager
};

}  // namespace tendon
