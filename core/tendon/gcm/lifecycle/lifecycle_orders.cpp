#include <tendon/gcm/lifecycle/lifecycle_orders.h>

#include <tendon/base/clock.h>
#include <tendon/gcm/lifecycle/followers.h>
#include <tendon/gcm/lifecycle/lifecycle_plan.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/process/lifecycle/configuration_base.h>

#include <algorithm>

namespace tendon::server {
namespace {

using message::LifecycleOrder;
using message::LifecycleOutcome;
using std::chrono::milliseconds;
using std::chrono::nanoseconds;

/// An undo sends all its orders within this many times the time limit of one order. The client
/// waits for one more time limit (GcmClient::kUndoTimeouts). In this time, the undo can stop
/// components that must not run.
constexpr int kUndoOrderTimeouts = 5;

std::string PathOf(const LifecycleOrder& order) {
  return order.component.empty() ? order.process : order.process + "/" + order.component;
}

std::string ObjectOf(const LifecycleOrder& order) {
  return order.component.empty() ? "'" + order.library + "'" : PathOf(order);
}

bool IsSilence(const Error& error) {
  return error.code == ErrorCode::kTimeout || error.code == ErrorCode::kUnreachable;
}

Error NotBegunError(const LifecycleOrder& order) {
  return {ErrorCode::kFailed, "process '" + order.process + "' did not begin in time to " +
                                  std::string(ToString(order.verb)) + " " + ObjectOf(order) +
                                  ": nothing was done, and the order is cancelled"};
}

Error UnknownOutcomeError(const LifecycleOrder& order, const Error& why) {
  const std::string known = "; outcome unknown";
  return {ErrorCode::kTimeout, why.message + (why.message.ends_with(known) ? "" : known) +
                                   "; see: gcm show " + PathOf(order)};
}

/// Returns the components that the undo of a step starts together with the component of the step.
std::vector<std::string> StoppedWith(const message::HistoryEntry& step) {
  const bool is_stop = step.verb == ToString(LifecycleVerb::kStop);
  return is_stop ? FollowersOf(step.lifecycle) : std::vector<std::string>();
}

}  // namespace

LifecycleOrders::LifecycleOrders(Parts parts, Locked locked, milliseconds timeout)
    : OrderSender(parts.registry, parts.deferred, parts.worker),
      parts_(parts),
      locked_(std::move(locked)),
      timeout_(timeout) {}

void LifecycleOrders::ExecuteOrder(const LifecycleOrder& order, const std::string& who,
                                   Done<None> done) {
  const Catalogue& catalogue = parts_.registry.catalogue();
  const Path path{order.process, order.component};
  const bool is_stop = order.verb == LifecycleVerb::kStop;
  if (is_stop) CancelStarts(path);
  if (auto checked = CheckTarget(catalogue, order); !checked) {
    return Reply(std::move(done), Result<None>(checked.error()));
  }
  const auto claimed = is_stop ? std::move(done) : Claim(path, std::move(done));
  if (!claimed) return;
  if (auto checked = CheckConfiguration(order); !checked) {
    return Reply(claimed, Result<None>(checked.error()));
  }
  message::HistoryEntry entry{.verb = StepVerbOf(order),
                              .lifecycle = StepOf(catalogue, order),
                              .who = who,
                              .instance = InstanceOf(catalogue, order.process)};
  SendOrder(order, [locked = locked_, entry = std::move(entry), claimed](const auto& outcome) {
    locked([&](LifecycleOrders& self) { self.Record(entry, outcome, claimed); });
  });
}

/// Checks that the present configuration is still the base of the order, if the order changes a
/// configuration. Otherwise the error names the program that has changed the configuration, if this
/// program is known. The process checks this again, because it has the newest state.
Result<void> LifecycleOrders::CheckConfiguration(const LifecycleOrder& order) const {
  const auto* now = parts_.registry.catalogue().FindComponent(order.process, order.component);
  if (order.verb != LifecycleVerb::kConfigure || now == nullptr) return {};
  UndoMark last;  // the program that made the last change, which is a step or its undo
  std::string made;
  for (const message::HistoryEntry& step : parts_.history.steps().entries) {
    const message::LifecycleStep& lifecycle = step.lifecycle;
    const bool is_ours = step.verb == ToString(LifecycleVerb::kConfigure) &&
                         lifecycle.process == order.process &&
                         lifecycle.component == order.component;
    if (!is_ours) continue;
    const UndoMark change =
        step.undone ? parts_.history.undo_of(step.id) : UndoMark{step.who, step.when};
    if (std::max(change.when, step.when) < last.when) continue;
    last = change;
    made = step.undone ? lifecycle.former : lifecycle.configuration;
  }
  const bool is_its_doing = !last.who.empty() && made == now->configuration;
  const std::string by =
      is_its_doing ? " by " + last.who + " at " + WallTimeText(last.when) : std::string();
  return CheckBase(order, now->configuration, by);
}

/// Records the step if it was executed, or if this is unknown. Then replies.
void LifecycleOrders::Record(message::HistoryEntry entry, const Result<LifecycleOutcome>& outcome,
                             const Done<None>& done) {
  Result<None> reply = outcome ? Result<None>(None{}) : outcome.error();
  if (outcome && !outcome->warning.empty()) {
    reply = Error{ErrorCode::kFailed, "done, but: " + outcome->warning};
  }
  entry.is_unknown = !outcome && IsSilence(outcome.error());
  if (outcome) AddOutcome(*outcome, entry);
  const bool is_step = !entry.lifecycle.process.empty() && (outcome || entry.is_unknown);
  if (!is_step || LeavesAsItWas(entry)) return Reply(done, reply);
  entry.when = WallTime();
  parts_.history.Record(std::move(entry), [done, reply] { done(reply); });
}

void LifecycleOrders::Undo(const message::HistoryEntry& step, std::chrono::nanoseconds timeout,
                           Connect connect, Done<None> done) {
  const message::LifecycleStep& lifecycle = step.lifecycle;
  const auto checked = CheckUndo(parts_.registry.catalogue(), step);
  if (!checked) return Reply(std::move(done), Result<None>(checked.error()));
  auto claimed = Claim({lifecycle.process, lifecycle.component}, std::move(done));
  for (const std::string& follower : StoppedWith(step)) {
    if (claimed) claimed = Claim({lifecycle.process, follower}, claimed);
  }
  if (!claimed) return;
  UndoPlan plan = PlanUndo(step, timeout);
  const SteadyTime until = SteadyClock().Now() + kUndoOrderTimeouts * Longest(TimeoutOf(timeout));
  const auto start = [locked = locked_, then = std::move(plan.then), until,
                      claimed](const auto& connected) {
    if (!connected || then.empty()) return claimed(connected);
    locked([&](LifecycleOrders& self) { self.RunAgain(then, until, claimed); });
  };
  SendAll(std::move(plan.first), until,
          [connect = std::move(connect), start, claimed](const auto& done_so_far) {
            if (!done_so_far) return claimed(done_so_far);
            connect(start);
          });
}

Result<void> LifecycleOrders::Begin(std::uint64_t order, const std::string& by) {
  const auto found = sent_.find(order);
  if (found == sent_.end() || found->second.path.first != by || found->second.is_void) {
    return Error{ErrorCode::kFailed, "the order is cancelled: no client waits for it any more"};
  }
  found->second.is_begun = true;
  return {};
}

void LifecycleOrders::ListClasses(const std::string& process, Done<message::Classes> done) {
  using message::Classes;
  const auto entry = LookUpProcess(parts_.registry.catalogue(), process);
  if (!entry) return Reply(std::move(done), Result<Classes>(entry.error()));
  if (auto present = RequirePresent((*entry)->process); !present) {
    return Reply(std::move(done), Result<Classes>(present.error()));
  }
  Send<Classes>(message::kGetClasses, process, message::GetClasses{process}, timeout_,
                std::move(done));
}

/// Marks the component as busy. Returns a wrapped `done` that also releases the component. If
/// another order for the component is in progress, replies with an error and returns null.
LifecycleOrders::Done<None> LifecycleOrders::Claim(const Path& path, Done<None> done) {
  // Orders that do not concern a component are executed by a process one at a time.
  if (path.second.empty()) return done;
  if (!busy_.emplace(path, false).second) {
    Reply(std::move(done),
          Result<None>(Error{
              ErrorCode::kFailed,
              path.first + "/" + path.second +
                  " is being changed by another request; try again when that request is done"}));
    return nullptr;
  }
  return [locked = locked_, path, done = std::move(done)](Result<None> result) {
    locked([&](LifecycleOrders& self) { self.busy_.erase(path); });
    done(std::move(result));
  };
}

/// Cancels orders that could start the component and were not begun yet.
void LifecycleOrders::CancelStarts(const Path& path) {
  const auto claim = busy_.find(path);
  if (claim != busy_.end()) claim->second = true;
  for (auto& [id, given] : sent_) {
    const bool starts =
        given.verb == LifecycleVerb::kStart || given.verb == LifecycleVerb::kRestart;
    if (given.path == path && starts && !given.is_begun) given.is_void = true;
  }
}

void LifecycleOrders::SendOrder(LifecycleOrder order, LifecycleDone done) {
  if (auto checked = CheckTarget(parts_.registry.catalogue(), order); !checked) {
    return Reply(std::move(done), Result<LifecycleOutcome>(checked.error()));
  }
  order.timeout = TimeoutOf(order.timeout);
  order.id = ++last_id_;
  sent_[order.id] = {.path = {order.process, order.component}, .verb = order.verb};
  const auto heard = [locked = locked_, order,
                      done = std::move(done)](Result<LifecycleOutcome> obeyed) {
    bool is_begun = true;  // as far as the GCM knows
    locked(
        [&](LifecycleOrders& self) { is_begun = self.sent_.extract(order.id).mapped().is_begun; });
    if (!obeyed && IsSilence(obeyed.error())) {
      obeyed = is_begun ? UnknownOutcomeError(order, obeyed.error()) : NotBegunError(order);
    }
    done(std::move(obeyed));
  };
  Send<LifecycleOutcome>(message::kLifecycleOrder, order.process, order, Longest(order.timeout),
                         heard);
}

nanoseconds LifecycleOrders::TimeoutOf(nanoseconds asked) const {
  if (asked <= nanoseconds(0)) return timeout_ * 2 / 3;
  return std::min<nanoseconds>(asked, std::chrono::hours(1));
}

/// Returns how long to wait for the reply to an order. The client waits longer: twice the
/// timeout.
milliseconds LifecycleOrders::Longest(nanoseconds timeout) const {
  const auto most = std::chrono::ceil<milliseconds>(timeout);
  return most + std::min(timeout_, most / 2);
}

/// Sends the orders one after the other. Ends at the first order that fails, or at the time
/// `until`.
void LifecycleOrders::SendAll(std::vector<LifecycleOrder> orders, SteadyTime until,
                              Done<None> done) {
  if (orders.empty()) return Reply(std::move(done), Result<None>(None{}));
  LifecycleOrder first = orders.front();
  const auto claim = busy_.find({first.process, first.component});
  if (first.verb == LifecycleVerb::kStart && claim != busy_.end() && claim->second) {
    return Reply(
        std::move(done),
        Result<None>(Error{ErrorCode::kFailed, PathOf(first) + " has been ordered to stop, so "
                                                               "it is not started"}));
  }
  const auto timeout = TimeoutWithin(TimeoutOf(first.timeout), until - SteadyClock().Now());
  if (!timeout) {
    return Reply(
        std::move(done),
        Result<None>(Error{ErrorCode::kTimeout,
                           "the time limit of the request was reached before the GCM could " +
                               std::string(ToString(first.verb)) + " " + PathOf(first)}));
  }
  first.timeout = *timeout;
  orders.erase(orders.begin());
  SendOrder(first, [locked = locked_, rest = std::move(orders), until, done](const auto& obeyed) {
    if (!obeyed) return done(obeyed.error());
    if (rest.empty()) return done(None{});
    locked([&](LifecycleOrders& self) { self.SendAll(rest, until, done); });
  });
}

/// Sends orders whose first order starts the leader of the other components. If a later order
/// fails, stops the leader. Then the other components stop, too.
void LifecycleOrders::RunAgain(std::vector<LifecycleOrder> orders, SteadyTime until,
                               Done<None> done) {
  const LifecycleOrder leader = orders.front();
  orders.erase(orders.begin());
  const auto take_back = [locked = locked_, leader, done](const Result<None>& others) {
    if (others) return done(others);
    LifecycleOrder stop = leader;
    stop.verb = LifecycleVerb::kStop;
    locked([&](LifecycleOrders& self) {
      self.SendOrder(stop, [done, others](const auto& /*stopped*/) { done(others); });
    });
  };
  SendAll({leader}, until,
          [locked = locked_, others = std::move(orders), until, done, take_back](const auto& runs) {
            if (!runs) return done(runs);
            locked([&](LifecycleOrders& self) { self.SendAll(others, until, take_back); });
          });
}

}  // namespace tendon::server
