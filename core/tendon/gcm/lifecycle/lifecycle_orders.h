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

/// Orders for the lifecycle of components. Forwards each order to its LCM, one at a time for each
/// component, and records it in the history. A stop is always forwarded; earlier orders that are
/// still pending do not start the component any more.
///
/// An LCM asks before it executes an order (Begin()). An order that was not begun in time is
/// cancelled and never executed. An order that was begun, but whose outcome does not arrive in
/// time, is recorded with an unknown outcome.
///
/// No thread waits. All functions are called under the owner's lock; `done` is called once, without
/// it.
class LifecycleOrders : private OrderSender {
 public:
  /// Calls its argument with the LifecycleOrders, under the owner's lock, and then runs the
  /// deferred actions. Does nothing if the owner is gone.
  using Locked = std::function<void(const std::function<void(LifecycleOrders&)>&)>;
  template <typename T>
  using Done = OrderSender::Done<T>;

  struct Parts {
    Registry& registry;
    StepHistory& history;
    DeferredActions& deferred;
    Worker& worker;  ///< provides timeouts
  };
  /// `timeout` is the time for the answer to an order, in addition to its patience.
  LifecycleOrders(Parts parts, Locked locked, std::chrono::milliseconds timeout);

  /// Gives an order that `who` has requested.
  void ExecuteOrder(const message::LifecycleOrder& order, const std::string& who, Done<None> done);
  /// Makes connections, then calls its argument, perhaps under the lock.
  using Connect = std::function<void(Done<None>)>;
  /// Undoes a step. Calls `connect`, without the lock, before components are started. Not recorded
  /// in the history.
  void Undo(const message::HistoryEntry& step, std::chrono::nanoseconds patience, Connect connect,
            Done<None> done);
  /// Called when process `by` is about to execute an order; an error cancels the order.
  [[nodiscard]] Result<void> Begin(std::uint64_t order, const std::string& by);
  void ListClasses(const std::string& process, Done<message::Classes> done);

 private:
  using Path = std::pair<std::string, std::string>;
  using LifecycleDone = Done<message::LifecycleOutcome>;

  /// An order that was sent and not answered yet.
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
  [[nodiscard]] std::chrono::nanoseconds PatienceOf(std::chrono::nanoseconds asked) const;
  [[nodiscard]] std::chrono::milliseconds Longest(std::chrono::nanoseconds patience) const;
  void SendAll(std::vector<message::LifecycleOrder> orders, SteadyTime until, Done<None> done);
  void RunAgain(std::vector<message::LifecycleOrder> orders, SteadyTime until, Done<None> done);
  void Record(message::HistoryEntry entry, const Result<message::LifecycleOutcome>& outcome,
              const Done<None>& done);

  Parts parts_;
  const Locked locked_;
  const std::chrono::milliseconds timeout_;
  std::map<Path, bool> busy_;  // components with a pending order; true if a stop was requested
  std::map<std::uint64_t, SentOrder> sent_;
  std::uint64_t last_id_ = 0;
};

}  // namespace tendon::server
