#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/history.h>
#include <tendon/gcm/server/outbox.h>
#include <tendon/gcm/server/registry.h>
#include <tendon/middleware/body.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tendon::server {

/// Orders for the life of components: passes them on to the LCM that is meant, one at a time for
/// each component, and keeps in the history what was done. A stop is always passed on, and what it
/// meets on its way starts the component no more.
///
/// An LCM asks before it carries out an order (Begin()). What was not begun in time is void: it is
/// not done, and never will be. What was begun, and of which nobody hears in time, is kept in the
/// history as unknown.
///
/// Nobody waits in a thread. All functions are called under the lock of the owner; `done` is called
/// once, without.
class LifeOrders {
 public:
  /// Calls its argument under the owner's lock, with the LifeOrders; not at all once the owner is
  /// gone. What the argument adds to the outbox is sent afterwards.
  using Locked = std::function<void(const std::function<void(LifeOrders&)>&)>;
  template <typename T>
  using Done = std::function<void(Result<T>)>;

  struct Parts {
    Registry& registry;
    History& history;
    Outbox& outbox;
    Worker& worker;  ///< watches over deadlines
  };
  /// `timeout` is that of an order's answer, beyond what it may take.
  LifeOrders(Parts parts, Locked locked, std::chrono::milliseconds timeout);

  /// `who` asked for it.
  void Steer(const message::LifeOrder& order, const std::string& who, Done<None> done);
  /// Makes connections, and calls its argument, which may be under the lock.
  using Connect = std::function<void(Done<None>)>;
  /// Unmakes a step. `connect` is called, without the lock, before anything is started. Not a step
  /// in the history.
  void Undo(const message::HistoryEntry& step, std::chrono::nanoseconds patience, Connect connect,
            Done<None> done);
  /// The process `by` is about to carry out an order: a refusal says that it must not.
  [[nodiscard]] Result<void> Begin(std::uint64_t order, const std::string& by);
  void ListClasses(const std::string& process, Done<message::Classes> done);

 private:
  using Path = std::pair<std::string, std::string>;
  using LifeDone = Done<message::LifeOutcome>;

  /// An order that was given, and is not answered.
  struct Given {
    Path path;
    LifeVerb verb;
    bool is_begun = false;
    bool is_void = false;
  };

  template <typename T>
  void Answer(Done<T> done, Result<T> result);
  [[nodiscard]] Result<void> CheckConfiguration(const message::LifeOrder& order) const;
  Done<None> Claim(const Path& path, Done<None> done);
  void PassOnStop(const Path& path);
  template <typename T, Message Body>
  void Give(MessageType type, const std::string& process, const Body& body,
            std::chrono::milliseconds longest, Done<T> done);
  void GiveOrder(message::LifeOrder order, LifeDone done);
  [[nodiscard]] std::chrono::nanoseconds PatienceOf(std::chrono::nanoseconds asked) const;
  [[nodiscard]] std::chrono::milliseconds Longest(std::chrono::nanoseconds patience) const;
  void GiveAll(std::vector<message::LifeOrder> orders, SteadyTime until, Done<None> done);
  void RunAgain(std::vector<message::LifeOrder> orders, SteadyTime until, Done<None> done);
  void Record(message::HistoryEntry entry, const Result<message::LifeOutcome>& outcome,
              const Done<None>& done);

  Parts parts_;
  const Locked locked_;
  const std::chrono::milliseconds timeout_;
  std::map<Path, bool> busy_;  // components that an order is under way to; whether they are to stop
  std::map<std::uint64_t, Given> given_;
  std::uint64_t last_id_ = 0;
};

}  // namespace tendon::server
