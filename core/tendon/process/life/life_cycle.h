#pragma once

#include <tendon/manager/local_manager.h>
#include <tendon/process/life/component_maker.h>
#include <tendon/process/life/errands.h>
#include <tendon/process/life/messages.h>
#include <tendon/process/life/plugin_watch.h>

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// Does in a process what is ordered from afar: loads plug-ins, makes components of their classes,
/// configures, starts, suspends, stops and removes them. Each order has a thread of its own, for
/// plug-ins and components may take their time there: no order waits for another one, unless both
/// need a plug-in. Of one component there is one order at a time, but a stop is always obeyed; what
/// it interrupts does not start the component any more. There is always room for stops, whatever
/// else is under way. Thread-safe.
///
/// What a program has made by itself, it may hold on to: that can be started and stopped, but only
/// the program removes it.
class LifeCycle {
 public:
  /// Where it happens. Both outlive Stop().
  struct Parts {
    LocalManager& manager;
    std::string process;                      ///< its name
    std::shared_ptr<ComponentLoader> loader;  ///< nobody else's from now on; null: there is none
  };
  template <typename T>
  using Done = std::function<void(const Result<T>&)>;
  /// Asks whether the order still holds; called once, before it is carried out, if it is.
  using Begin = ComponentMaker::Begin;

  explicit LifeCycle(Parts parts) : parts_(std::move(parts)) {}

  /// `done` is called in a thread of the orders. What has not begun when the order's patience ends
  /// is refused, and not done later.
  void Obey(const message::LifeOrder& order, Begin begin, Done<message::LifeOutcome> done);
  void ListClasses(Done<message::Classes> done);

  /// From now on `changed` is called when plugins() tells something else, in a thread of its own,
  /// until Stop(). Does nothing where there is no loader.
  void WatchPlugins(std::function<void()> changed);
  /// Those that are loaded, and what has become of their files.
  [[nodiscard]] std::vector<PluginDescription> plugins() const;

  /// From now on orders are refused, and those under way start no component any more.
  void Close();
  /// Close(), and waits for what is under way, which may be long: the components are told to stop
  /// before, then.
  void Stop();

 private:
  using Outcome = Result<message::LifeOutcome>;
  class Claim;

  /// An order, and until when it is to be carried out.
  struct Given {
    const message::LifeOrder& order;
    SteadyTime deadline;
    const Begin& begin;
  };

  Outcome ExecuteGuarded(const Given& given);
  Outcome Execute(const Given& given);
  Outcome Load(const Given& given);
  Outcome StopIt(const Given& given);
  // Of a component that is claimed.
  Outcome Create(const Given& given);
  Outcome Configure(const Given& given);
  Outcome Steer(const Given& given, const Claim& claim);
  Outcome Restart(const Given& given, const Claim& claim);
  Outcome Remove(const Given& given);

  /// Whether the order still holds; afterwards it counts as begun.
  [[nodiscard]] Result<void> BeginNow(const Given& given) const;
  Result<void> StartUnlessStopped(const Given& given, const Claim& claim);

  Result<void> Add(ComponentMaker::Made made);
  Result<void> TakeOut(const std::string& component, SteadyTime deadline);
  [[nodiscard]] std::vector<ConnectionDescription> ConnectionsOf(
      const std::string& component) const;
  Result<void> Reconnect(const std::vector<ConnectionDescription>& connections);
  /// A component that was made of a class and that nobody runs after, or why it is not to be made
  /// anew or removed.
  [[nodiscard]] Result<ComponentDescription> FindOfClass(const std::string& component,
                                                         const std::string& what) const;
  [[nodiscard]] Result<ComponentDescription> Find(const std::string& component) const;

  const Parts parts_;
  ComponentMaker maker_{parts_.process, parts_.loader};
  std::mutex claims_mutex_;
  std::map<std::string, bool> claims_;  // components with an order; whether they are to stop
  bool is_ending_ = false;
  Errands errands_{parts_.process, 64};
  Errands stops_{parts_.process, 64};
  Errands looks_{parts_.process, 4};
  std::unique_ptr<PluginWatch> watch_;
};

}  // namespace tendon
