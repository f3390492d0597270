#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/members/order_sender.h>
#include <tendon/gcm/members/registry.h>
#include <tendon/gcm/step_history.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tendon::server {

/// Executes orders for the lifecycle of components. Forwards each order to the LCM of its process,
/// and records it in the history. Only one order for a component is in progress at a time. However,
/// a stop is forwarded even if another order is in progress; pending orders that could start the
/// component are then cancelled.
///
/// An LCM asks the GCM before it executes an order (Begin()). An order that does not begin in time
/// is cancelled and never executed. If an order has begun, but its outcome does not arrive in time,
/// the order is recorded with an unknown outcome.
///
/// No function blocks. All functions must be called while the owner's lock is held. `done` is
/// called once, after the lock is released.
class LifecycleOrders : private OrderSender {
 public:
  /// Takes the owner's lock, calls the given function with the LifecycleOrders, releases the lock,
  /// and runs the deferred actions. Does nothing if the owner no longer exists.
  using Locked = std::function<void(const std::function<void(LifecycleOrders&)>&)>;
  template <typename T>
  using Done = OrderSender::Done<T>;

  struct Parts {
    Registry& registry;
    StepHistory& history;
    DeferredActions& deferred;
    Worker& worker;  ///< provides timeouts
  };
  /// `timeout` is the time that the reply to an order may need in addition to the timeout of the
  /// order.
  LifecycleOrders(Parts parts, Locked locked, std::chrono::milliseconds timeout);

  /// Executes an order that `who` has requested.
  void ExecuteOrder(const message::LifecycleOrder& order, const std::string& who, Done<None> done);
  /// Restores connections, then calls the given function with the outcome. The lock may be held
  /// during this call.
  using Connect = std::function<void(Done<None>)>;
  /// Undoes a step. Calls `connect` without the lock, before it starts components. The undo is not
  /// recorded in the history.
  void Undo(const message::HistoryEntry& step, std::chrono::nanoseconds timeout, Connect connect,
            Done<None> done);
  /// Called when the process `by` is about to execute an order. If it returns an error, the process
  /// does not execute the order.
  [[nodiscard]] Result<void> Begin(std::uint64_t order, const std::string& by);
  void ListClasses(const std::string& process, Done<message::Classes> done);

 private:
  using Path = std::pair<std::string, std::string>;
  using LifecycleDone = Done<message::LifecycleOutcome>;

  /// An order that was sent, but not answered yet.
  struct SentOrder {
    Path path;
    LifecycleVerb verb;
    bool is_begun = false;
    bool is_void = false;
  };

  [[nodiscard]] Result<void> CheckConfiguration(const message::LifecycleOrder& order) const;
  Done<None> Claim(const Path& path, Done<None> done);
  void CancelStarts(const Path& path);
  void SendOrder(message::LifecycleOrder order, LifecycleDone done);
  [[nodiscard]] std::chrono::nanoseconds TimeoutOf(std::chrono::nanoseconds asked) const;
  [[nodiscard]] std::chrono::milliseconds Longest(std::chrono::nanoseconds timeout) const;
  void SendAll(std::vector<message::LifecycleOrder> orders, SteadyTime until, Done<None> done);
  void RunAgain(std::vector<message::LifecycleOrder> orders, SteadyTime until, Done<None> done);
  void Record(message::HistoryEntry entry, const Result<message::LifecycleOutcome>& outcome,
              const Done<None>& done);

  Parts parts_;
  const Locked locked_;
  const std::chrono::milliseconds timeout_;
  std::map<Path, bool> busy_;  // components with an order in progress; true if a stop was requested
  std::map<std::uint64_t, SentOrder> sent_;
  std::uint64_t last_id_ = 0;
};

}  // namespace tendon::server
