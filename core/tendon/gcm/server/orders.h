#pragma once

#include <tendon/gcm/history.h>
#include <tendon/gcm/life/life_orders.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/server/deferred_actions.h>
#include <tendon/gcm/server/registry.h>
#include <tendon/gcm/supervisor/supervisor.h>
#include <tendon/middleware/body.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <set>
#include <string>
#include <type_traits>

namespace tendon::server {

/// Connects and disconnects: checks a request against the catalogue, sends the order to the
/// required side's LCM, and records the change in the history. No thread waits. A failed request
/// changes nothing, as far as the LCM allows; any remaining change is in the history. All functions
/// are called under the owner's lock; `done` is called once, without it.
class Orders {
 public:
  /// Calls its argument with the Orders, under the owner's lock, and then flushes the outbox. Does
  /// nothing if the owner is gone.
  using Locked = std::function<void(const std::function<void(Orders&)>&)>;
  template <typename T>
  using Done = std::function<void(Result<T>)>;
  using ConnectDone = Done<ConnectionDescription>;

  struct Parts {
    Registry& registry;
    History& history;
    Outbox& outbox;
    Worker& worker;          ///< provides timeouts
    LifeOrders& life;        ///< undoes its own steps
    Supervisor& supervisor;  ///< undoes its own steps
  };
  Orders(Parts parts, Locked locked, std::chrono::milliseconds timeout);

  /// Makes a connection that `who` has requested.
  void Connect(const message::Wire& wire, const std::string& who, ConnectDone done);
  /// Replaces the connection of an interface; like Connect() if there is none.
  void Replace(const message::Wire& wire, const std::string& who, ConnectDone done);
  void Disconnect(const InterfaceName& required, const std::string& who, Done<None> done);
  void Undo(const message::StepSelection& which, const std::string& who,
            Done<message::HistoryEntry> done);
  /// Skips the newest step, so that earlier ones can be undone. Refused if its process is gone and
  /// may come back, or if the step can be undone and `which` does not name it.
  void PassOver(const message::StepSelection& which, const std::string& who,
                Done<message::HistoryEntry> done);

  /// Makes a connection that a returned process had before. Not recorded in the history.
  void HandBack(const message::Wire& wire);

 private:
  template <typename T>
  void Answer(Done<T> done, Result<T> result);
  template <typename T>
  Done<T> Claim(const InterfaceName& required, Done<T> done);
  template <typename T>
  void Record(message::HistoryEntry step, std::type_identity_t<Result<T>> answer, Done<T> done);

  // Changes of one interface, one at a time, not recorded in the history.

  using Planned = std::function<void(Orders&, const Result<message::Wiring>&)>;
  void Plan(const message::Wire& wire, Occupied occupied, const Planned& planned);
  void Make(const message::Wire& wire, ConnectDone done);
  void MakePending(const message::Wire& wire, const ConnectDone& done);
  void Break(const InterfaceName& required, ConnectDone done);

  struct Swapped {
    ConnectionDescription made;
    InterfaceName former;
  };
  struct Exchange {
    message::Wire wire;
    ConnectionDescription former;
    std::string who;
    Done<Swapped> done;
  };
  void Swap(const message::Wire& wire, const std::string& who, Done<Swapped> done);
  void MakeInstead(const Exchange& exchange, const Result<None>& broken);
  void Judge(const Exchange& exchange, const Result<ConnectionDescription>& made);
  void Restore(const Exchange& exchange, const Error& why);
  void Settle(const Exchange& exchange, Error why, const Result<ConnectionDescription>& restored);

  // Single orders to the required side's LCM, which executes them in order.

  template <typename T, Message Body>
  void Give(MessageType type, const InterfaceName& required, const Body& body, Done<T> done);
  void GiveMake(const message::Wiring& wiring, ConnectDone done);
  void GiveBreak(const InterfaceName& required, Done<None> done);

  [[nodiscard]] Result<message::HistoryEntry> Newest(const message::StepSelection& which) const;
  void UndoWire(const message::HistoryEntry& step, const std::string& who, const ConnectDone& done);
  void UndoLife(const message::HistoryEntry& step, std::chrono::nanoseconds patience,
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
