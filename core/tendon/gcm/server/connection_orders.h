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

/// Executes requests to connect and disconnect: checks the request against the catalogue, sends the
/// order to the LCM of the required side, and records the change in the history. A failed request
/// normally changes nothing. If the LCM could not restore the old connection, this change is
/// recorded in the history.
///
/// No function blocks. All functions must be called while the owner's lock is held. `done` is
/// called once, after the lock is released.
class ConnectionOrders : private OrderSender {
 public:
  /// Takes the owner's lock, calls the given function with the ConnectionOrders, releases the lock,
  /// and runs the deferred actions. Does nothing if the owner no longer exists.
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

  /// Makes a connection that `who` has requested. WhenConnected::kReplace replaces an existing
  /// connection of the required interface.
  void Connect(const message::ConnectionEnds& ends, WhenConnected when_connected,
               const std::string& who, ConnectDone done);
  void Disconnect(const InterfaceName& required, const std::string& who, Done<None> done);
  void Undo(const message::StepSelection& which, const std::string& who,
            Done<message::HistoryEntry> done);
  /// Marks the newest step as skipped, so that earlier steps can be undone. Refuses this if the
  /// process of the step is lost but may come back. If the step could be undone, `which` must give
  /// its number.
  void SkipNewestStep(const message::StepSelection& which, const std::string& who,
                      Done<message::HistoryEntry> done);

  /// Restores a connection whose process was lost and has returned. This is not recorded in the
  /// history.
  void RestoreConnection(const message::ConnectionEnds& ends);

 private:
  template <typename T>
  Done<T> Claim(const InterfaceName& required, Done<T> done);
  template <typename T>
  void Record(message::HistoryEntry step, std::type_identity_t<Result<T>> reply, Done<T> done);

  // These functions change the connection of one required interface. Only one change of an
  // interface is in progress at a time. They do not record the change in the history, except
  // OnRestored() of a ReplaceOrder.

  class ConnectOrder;
  class ReplaceOrder;
  struct Replacement {
    ConnectionDescription made;
    InterfaceName former;
  };

  using Planned = std::function<void(ConnectionOrders&, const Result<message::ConnectionPlan>&)>;
  void Plan(const message::ConnectionEnds& ends, WhenConnected when_connected,
            const Planned& planned);
  void Make(const message::ConnectionEnds& ends, ConnectDone done);
  void MakePending(const message::ConnectionEnds& ends, const ConnectDone& done);
  void Break(const InterfaceName& required, ConnectDone done);
  void Exchange(const message::ConnectionEnds& ends, const std::string& who,
                Done<Replacement> done);
  /// Returns a handler that calls the function `step` of `order` while the owner's lock is held.
  template <typename Order, typename Outcome>
  Done<Outcome> Step(std::shared_ptr<Order> order,
                     void (Order::*step)(ConnectionOrders&, const Result<Outcome>&));

  // These functions send a single order to the LCM of the required side. The LCM executes its
  // orders in the order of sending.

  void SendMake(const message::ConnectionPlan& plan, ConnectDone done);
  void SendBreak(const InterfaceName& required, Done<None> done);

  [[nodiscard]] Result<message::HistoryEntry> Newest(const message::StepSelection& which) const;
  void UndoConnection(const message::HistoryEntry& step, const std::string& who,
                      const ConnectDone& done);
  void UndoLifecycle(const message::HistoryEntry& step, std::chrono::nanoseconds timeout,
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
