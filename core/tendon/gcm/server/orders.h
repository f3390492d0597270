#pragma once

#include <tendon/gcm/history.h>
#include <tendon/gcm/life/life_orders.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/server/outbox.h>
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

/// Connects and disconnects: checks a request against the catalogue, gives the order to the
/// required side's LCM, and keeps in the history what was done. Nobody waits in a thread; what
/// fails changes nothing, as far as the LCM lets us; otherwise the history has that change. All
/// functions are called under the lock of the owner; `done` is called
/// once, without.
class Orders {
 public:
  /// Calls its argument under the owner's lock, with the Orders; not at all once the owner is gone.
  /// What the argument adds to the outbox is sent afterwards.
  using Locked = std::function<void(const std::function<void(Orders&)>&)>;
  template <typename T>
  using Done = std::function<void(Result<T>)>;
  using ConnectDone = Done<ConnectionDescription>;

  struct Parts {
    Registry& registry;
    History& history;
    Outbox& outbox;
    Worker& worker;          ///< watches over deadlines
    LifeOrders& life;        ///< unmakes its own steps
    Supervisor& supervisor;  ///< likewise
  };
  Orders(Parts parts, Locked locked, std::chrono::milliseconds timeout);

  /// `who` asked for it.
  void Connect(const message::Wire& wire, const std::string& who, ConnectDone done);
  /// As Connect() where it is not connected.
  void Replace(const message::Wire& wire, const std::string& who, ConnectDone done);
  void Disconnect(const InterfaceName& required, const std::string& who, Done<None> done);
  void Undo(const message::WhichStep& which, const std::string& who,
            Done<message::HistoryEntry> done);
  /// Leaves the newest step as it is, for good, so that those before it can be undone; only where
  /// that cannot be undone as things are, or is named, and not because its process is away, which
  /// may come back.
  void PassOver(const message::WhichStep& which, const std::string& who,
                Done<message::HistoryEntry> done);

  /// A connection which a returned process had before. Not a step in the history.
  void HandBack(const message::Wire& wire);

 private:
  template <typename T>
  void Answer(Done<T> done, Result<T> result);
  template <typename T>
  Done<T> Claim(const InterfaceName& required, Done<T> done);
  template <typename T>
  void Record(message::HistoryEntry step, std::type_identity_t<Result<T>> answer, Done<T> done);

  // Changes of an interface, one at a time, without a trace in the history.

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

  // Single orders to the required side's LCM, which obeys them in this order.

  template <typename T, Message Body>
  void Give(MessageType type, const InterfaceName& required, const Body& body, Done<T> done);
  void GiveMake(const message::Wiring& wiring, ConnectDone done);
  void GiveBreak(const InterfaceName& required, Done<None> done);

  [[nodiscard]] Result<message::HistoryEntry> Newest(const message::WhichStep& which) const;
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
  std::set<InterfaceName> busy_;  // required interfaces that are being changed
};

}  // namespace tendon::server
