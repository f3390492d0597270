#pragma once

#include <tendon/manager/local_manager.h>
#include <tendon/process/lifecycle/component_factory.h>
#include <tendon/process/lifecycle/lifecycle_messages.h>
#include <tendon/process/lifecycle/plugin_watch.h>
#include <tendon/process/lifecycle/thread_per_task.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// Executes orders from the GCM in a process: loads plug-ins, creates components of their classes,
/// configures, starts, suspends, stops and removes them. Thread-safe.
///
/// Each order has its own thread, because plug-ins and components may take long. Orders wait for
/// each other only if both need a plug-in. A component executes one order at a time, but accepts a
/// stop at any time; then the interrupted order does not start the component again. The number of
/// orders is limited; stops do not count.
///
/// The program that created a component itself is the only one that can remove it. Orders can start
/// and stop such a component.
class LifecycleExecutor {
 public:
  /// The parts of the process in which orders are executed. `manager` and `loader` must live until
  /// Stop() returns.
  struct Parts {
    LocalManager& manager;
    std::string process;                      ///< name of the process
    std::shared_ptr<ComponentLoader> loader;  ///< used only by this object; may be null
  };
  template <typename T>
  using Done = std::function<void(const Result<T>&)>;
  /// Called at most once, just before the execution. An error cancels the order.
  using Begin = ComponentFactory::Begin;

  explicit LifecycleExecutor(Parts parts) : parts_(std::move(parts)) {}

  /// Executes an order, and calls `done` in the order's thread. If the time limit of an order ends
  /// before the order has begun, the order is refused and never executed.
  void ExecuteOrder(const message::LifecycleOrder& order, Begin begin,
                    Done<message::LifecycleOutcome> done);
  void ListClasses(Done<message::Classes> done);

  /// Calls `changed` whenever plugins() changes, in a separate thread, until Stop(). Does nothing
  /// without a loader.
  void WatchPlugins(std::function<void()> changed);
  /// The loaded plug-ins and the state of their files.
  [[nodiscard]] std::vector<PluginDescription> plugins() const;

  /// Refuses new orders. Running orders start no more components.
  void Close();
  /// Calls Close(), requests the stop of the components, and waits for running orders, which may
  /// take long.
  void Stop();

 private:
  using Outcome = Result<message::LifecycleOutcome>;
  class Claim;

  /// An order and its deadline.
  struct TimedOrder {
    const message::LifecycleOrder& order;
    SteadyTime deadline;
    const Begin& begin;
  };

  Outcome ExecuteGuarded(const TimedOrder& given);
  Outcome Execute(const TimedOrder& given);
  Outcome Load(const TimedOrder& given);
  Outcome StopComponent(const TimedOrder& given);
  // The caller of these functions must hold the component's claim.
  Outcome Create(const TimedOrder& given);
  Outcome Configure(const TimedOrder& given);
  Outcome StartOrSuspend(const TimedOrder& given, const Claim& claim);
  Outcome Restart(const TimedOrder& given, const Claim& claim);
  Outcome Remove(const TimedOrder& given);

  /// Checks that the order is still valid. If so, marks it as begun.
  [[nodiscard]] Result<void> MarkBegun(const TimedOrder& given) const;
  Result<void> StartUnlessStopped(const TimedOrder& given, const Claim& claim);

  Result<void> Add(ComponentFactory::CreatedParts made);
  Result<void> RemoveFromProcess(const std::string& component, SteadyTime deadline);
  [[nodiscard]] std::vector<ConnectionDescription> ConnectionsOf(
      const std::string& component) const;
  Result<void> Reconnect(const std::vector<ConnectionDescription>& connections);
  /// Finds a component that can be replaced or removed: it was created from a class, and no other
  /// component runs after it. Otherwise returns an error that gives the reason.
  [[nodiscard]] Result<ComponentDescription> FindOfClass(const std::string& component,
                                                         const std::string& what) const;
  [[nodiscard]] Result<ComponentDescription> Find(const std::string& component) const;

  const Parts parts_;
  ComponentFactory factory_{parts_.process, parts_.loader};
  std::mutex claims_mutex_;
  std::map<std::string, bool> claims_;  // components with an order; true if a stop has arrived
  bool is_ending_ = false;
  ThreadPerTask orders_{parts_.process, 64};
  ThreadPerTask stops_{parts_.process, 64};
  ThreadPerTask class_queries_{parts_.process, 4};
  std::unique_ptr<PluginWatch> watch_;
};

}  // namespace tendon
