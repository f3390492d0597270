#pragma once

#include <tendon/gcm/lifecycle/lifecycle_orders.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/members/order_sender.h>
#include <tendon/gcm/members/registry.h>
#include <tendon/gcm/step_history.h>
#include <tendon/gcm/supervisor/supervisor.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <type_traits>

namespace tendon::server {

/// Connects and disconnects: checks a request against the catalogue, sends the order to the
/// required side's LCM, and records the change in the history. No thread waits. A failed request
/// changes nothing, as far as the LCM allows; any remaining change is in the history. All functions
/// are called under the owner's lock; `done` is called once, without it.
class ConnectionOrders : private OrderSender {
 public:
  /// Calls its argument with the ConnectionOrders, under the owner's lock, and then runs the
  /// deferred actions. Does nothing if the owner is gone.
  using Locked = std::function<void(const std::function<void(ConnectionOrders&)>&)>;
  template <typename T>
  using Done = OrderSender::Done<T>;
  using ConnectDone = Done<ConnectionDescription>;

  struct Parts {
    Registry& registry;
    StepHistory& history;
    DeferredActions& deferred;
    Worker& worker;              ///< provides timeouts
    LifecycleOrders& lifecycle;  ///< undoes its own steps
    Supervisor& supervisor;      ///< undoes its own steps
  };
  ConnectionOrders(Parts parts, Locked locked, std::chrono::milliseconds timeout);

  /// Makes a connection that `who` has requested. With WhenConnected::kReplace, it replaces an
  /// existing connection of the required interface to another provided interface.
  void Connect(const message::Wire& wire, WhenConnected when_connected, const std::string& who,
               ConnectDone done);
  void Disconnect(const InterfaceName& required, const std::string& who, Done<None> done);
  void Undo(const message::StepSelection& which, const std::string& who,
            Done<message::HistoryEntry> done);
  /// Skips the newest step, so that earlier steps can be undone. Refused if the process of the step
  /// is gone and may come back. Also refused if the step could be undone, unless `which` names it.
  void PassOver(const message::StepSelection& which, const std::string& who,
                Done<message::HistoryEntry> done);

  /// Makes a connection that a returned process had before. Not recorded in the history.
  void RestoreConnection(const message::Wire& wire);

 private:
  template <typename T>
  Done<T> Claim(const InterfaceName& required, Done<T> done);
  template <typename T>
  void Record(message::HistoryEntry step, std::type_identity_t<Result<T>> answer, Done<T> done);

  // These change one interface. One change of an interface runs at a time, and none is recorded.

  class ConnectOrder;
  class ReplaceOrder;
  struct Replacement {
    ConnectionDescription made;
    InterfaceName former;
  };

  using Planned = std::function<void(ConnectionOrders&, const Result<message::ConnectionPlan>&)>;
  void Plan(const message::Wire& wire, WhenConnected when_connected, const Planned& planned);
  void Make(const message::Wire& wire, ConnectDone done);
  void MakePending(const message::Wire& wire, const ConnectDone& done);
  void Break(const InterfaceName& required, ConnectDone done);
  void Exchange(const message::Wire& wire, const std::string& who, Done<Replacement> done);
  /// Returns a handler that takes the owner's lock and then calls the function `step` of `order`.
  template <typename Order, typename Reply>
  Done<Reply> Step(std::shared_ptr<Order> order,
                   void (Order::*step)(ConnectionOrders&, const Result<Reply>&));

  // Single orders to the required side's LCM, which executes them in order.

  void SendMake(const message::ConnectionPlan& plan, ConnectDone done);
  void SendBreak(const InterfaceName& required, Done<None> done);

  [[nodiscard]] Result<message::HistoryEntry> Newest(const message::StepSelection& which) const;
  void UndoWire(const message::HistoryEntry& step, const std::string& who, const ConnectDone& done);
  void UndoLifecycle(const message::HistoryEntry& step, std::chrono::nanoseconds patience,
                     const Done<None>& done);
  void MakeAgain(const message::HistoryEntry& step, const Done<None>& done);
  [[nodiscard]] Result<void> CheckUndo(const message::HistoryEntry& step) const;
  void FinishUndo(message::HistoryEntry step, const std::string& who, const Result<void>& outcome,
                  Done<message::HistoryEntry> done);

  Parts parts_;
  const Locked locked_;
  const std::chrono::milliseconds timeout_;
  std::set<InterfaceName> busy_;  // required interfaces with a change in progress
};

}  // namespace tendon::server
