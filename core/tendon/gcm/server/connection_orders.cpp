#include <tendon/gcm/server/connection_orders.h>

#include <tendon/base/log.h>
#include <tendon/gcm/conflicting_types.h>
#include <tendon/gcm/lifecycle/undo_check.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>
#include <tendon/process/schema_exchange.h>

#include <memory>
#include <utility>

namespace tendon::server {
namespace {

void LogRestored(const message::ConnectionEnds& ends, const Result<void>& outcome,
                 ConnectionRestorer::Verdict verdict) {
  const std::string what = ToString(ends.required) + " to " + ToString(ends.provided);
  if (outcome) return Log(LogLevel::kInfo, "gcm", "restored the connection of " + what);
  const bool is_still_trying = verdict == ConnectionRestorer::Verdict::kStillTrying;
  // After kExists, the process has restored the connection itself.
  if (is_still_trying || outcome.error().code == ErrorCode::kExists) return;
  const bool is_over = verdict == ConnectionRestorer::Verdict::kGivenUp;
  Log(LogLevel::kWarning, "gcm",
      "cannot restore the connection of " + what + ": " + outcome.error().message +
          (is_over ? "" : "; trying again"));
}

/// Returns true if it is unknown whether the process has executed or will execute the order.
bool IsOutcomeUnknown(const Error& error) {
  return error.code == ErrorCode::kTimeout || error.code == ErrorCode::kUnreachable;
}

Error NothingToUndo() { return {ErrorCode::kFailed, "there is nothing to undo"}; }

Error MayComeBack(const message::HistoryEntry& step) {
  return {ErrorCode::kFailed, WholeText(step) + " is not skipped, because process '" +
                                  ProcessOf(step) +
                                  "' is lost, and the step can still be undone if the process "
                                  "comes back; if the process never comes back: gcm forget " +
                                  ProcessOf(step)};
}

Result<void> OutcomeOf(const auto& result) { return result ? Result<void>() : result.error(); }

}  // namespace

/// Makes a connection. The object exists until all its callbacks were called. Each step is called
/// while the owner's lock is held.
class ConnectionOrders::ConnectOrder final : public std::enable_shared_from_this<ConnectOrder> {
 public:
  ConnectOrder(message::ConnectionEnds ends, ConnectDone done)
      : ends_(std::move(ends)), done_(std::move(done)) {}

  void Start(ConnectionOrders& orders);

 private:
  void OnPlanned(ConnectionOrders& orders, const Result<message::ConnectionPlan>& plan);

  const message::ConnectionEnds ends_;
  const ConnectDone done_;
};

/// Replaces the connection of a required interface if the new connection is possible: breaks the
/// old connection, makes the new one, and restores the old one if this fails. The object exists
/// until all its callbacks were called. Each step is called while the owner's lock is held.
class ConnectionOrders::ReplaceOrder final : public std::enable_shared_from_this<ReplaceOrder> {
 public:
  ReplaceOrder(message::ConnectionEnds ends, std::string who, Done<Replacement> done)
      : ends_(std::move(ends)), who_(std::move(who)), done_(std::move(done)) {}

  void Start(ConnectionOrders& orders);

 private:
  void OnPlanned(ConnectionOrders& orders, const Result<message::ConnectionPlan>& plan);
  void OnBroken(ConnectionOrders& orders, const Result<None>& broken);
  void OnMade(ConnectionOrders& orders, const Result<ConnectionDescription>& made);
  void Restore(ConnectionOrders& orders, const Error& why);
  void OnRestored(ConnectionOrders& orders, const Result<ConnectionDescription>& restored);
  void Fail(ConnectionOrders& orders, const Error& why) {
    orders.Reply(done_, Result<Replacement>(why));
  }

  const message::ConnectionEnds ends_;
  const std::string who_;
  Done<Replacement> done_;  // after OnPlanned(), it also releases the interface
  ConnectionDescription former_;
  Error why_;  // set by Restore()
};

ConnectionOrders::ConnectionOrders(Parts parts, Locked locked, std::chrono::milliseconds timeout)
    : OrderSender(parts.registry, parts.deferred, parts.worker),
      parts_(parts),
      locked_(std::move(locked)),
      timeout_(timeout) {}

void ConnectionOrders::Connect(const message::ConnectionEnds& ends, WhenConnected when_connected,
                               const std::string& who, ConnectDone done) {
  const auto* now = parts_.registry.catalogue().FindConnection(ends.required);
  const bool is_other = now != nullptr && now->provided != ends.provided;
  if (when_connected == WhenConnected::kReplace && is_other) {
    return Exchange(
        ends, who, [locked = locked_, ends, who, done = std::move(done)](const auto& replaced) {
          if (!replaced) return done(replaced.error());
          locked([&](ConnectionOrders& orders) {
            orders.Record({.verb = "replace", .ends = ends, .former = replaced->former, .who = who},
                          replaced->made, done);
          });
        });
  }
  Make(ends, [locked = locked_, ends, who, done = std::move(done)](const auto& made) {
    if (!made) return done(made);
    locked([&](ConnectionOrders& orders) {
      orders.Record({.verb = "connect", .ends = ends, .who = who}, *made, done);
    });
  });
}

void ConnectionOrders::Disconnect(const InterfaceName& required, const std::string& who,
                                  Done<None> done) {
  Break(required, [locked = locked_, who, done = std::move(done)](const auto& broken) {
    if (!broken) return done(broken.error());
    const message::ConnectionEnds ends{broken->required, broken->provided};
    locked([&](ConnectionOrders& orders) {
      orders.Record({.verb = "disconnect", .ends = ends, .who = who}, None{}, done);
    });
  });
}

Result<message::HistoryEntry> ConnectionOrders::Newest(const message::StepSelection& which) const {
  const auto step = parts_.history.last();
  if (!step) return NothingToUndo();
  if (which.id == 0 || which.id == step->id) return *step;
  return Error{ErrorCode::kFailed, "step " + std::to_string(which.id) +
                                       " is not the newest step any more; the newest step is " +
                                       WholeText(*step) + "; see: gcm history"};
}

void ConnectionOrders::Undo(const message::StepSelection& which, const std::string& who,
                            Done<message::HistoryEntry> done) {
  const auto step = Newest(which);
  if (!step) return Reply(std::move(done), step);
  if (const auto checked = CheckUndo(*step); !checked) {
    return Reply(std::move(done), Result<message::HistoryEntry>(checked.error()));
  }
  const auto finish = [locked = locked_, step = *step, who, done](const auto& outcome) {
    locked(
        [&](ConnectionOrders& orders) { orders.FinishUndo(step, who, OutcomeOf(outcome), done); });
  };
  if (IsProcessStep(*step)) return parts_.supervisor.Undo(*step, which.timeout, finish);
  if (IsLifecycleStep(*step)) return UndoLifecycle(*step, which.timeout, finish);
  UndoConnection(*step, who, finish);
}

void ConnectionOrders::UndoConnection(const message::HistoryEntry& step, const std::string& who,
                                      const ConnectDone& done) {
  const Catalogue& catalogue = parts_.registry.catalogue();
  const InterfaceName& required = step.ends.required;
  const bool is_replacement = step.verb == "replace";
  const message::ConnectionEnds former{required, is_replacement ? step.former : step.ends.provided};
  const auto* now = catalogue.FindConnection(required);
  if (step.verb == "connect") {
    Break(required, done);
  } else if (step.verb == "disconnect" && now != nullptr) {
    // A slow process has already restored the connection.
    Reply(done, Result(*now));
  } else if (WasPending(catalogue, parts_.history.steps(), step)) {
    MakePending(former, done);
  } else if (is_replacement) {
    Exchange(former, who, [done](const Result<Replacement>& replaced) {
      done(replaced ? Result(replaced->made) : replaced.error());
    });
  } else {
    Make(former, done);
  }
}

void ConnectionOrders::SkipNewestStep(const message::StepSelection& which, const std::string& who,
                                      Done<message::HistoryEntry> done) {
  auto step = Newest(which);
  if (!step) return Reply(std::move(done), step);
  if (which.id == 0 && CheckUndo(*step)) {
    const Error error{ErrorCode::kFailed, WholeText(*step) +
                                              " can be undone, so it is not skipped; to skip it "
                                              "anyway: gcm undo --skip --step " +
                                              std::to_string(step->id)};
    return Reply(std::move(done), Result<message::HistoryEntry>(error));
  }
  const auto* owner = parts_.registry.catalogue().FindProcess(ProcessOf(*step));
  if (owner != nullptr && owner->process.state == ProcessState::kLost &&
      owner->process.instance == step->instance) {
    const Error error = MayComeBack(*step);
    return Reply(std::move(done), Result<message::HistoryEntry>(error));
  }
  parts_.deferred.Add(
      [text = who + " skips " + WholeText(*step)] { Log(LogLevel::kInfo, "gcm", text); });
  step->passed_over = true;
  parts_.history.MarkPassedOver(step->id, [step = *step, done = std::move(done)] { done(step); });
}

void ConnectionOrders::RestoreConnection(const message::ConnectionEnds& ends) {
  Make(ends, [locked = locked_, ends](const auto& made) {
    const Result<void> outcome = OutcomeOf(made);
    auto verdict = ConnectionRestorer::Verdict::kStillTrying;
    locked([&](ConnectionOrders& orders) {
      verdict = orders.parts_.registry.OnRestored(ends, outcome);
    });
    LogRestored(ends, outcome, verdict);
  });
}

/// Marks the interface as busy. Returns a wrapped `done` that also releases the interface. If
/// another change of the interface is in progress, replies with an error and returns null.
template <typename T>
ConnectionOrders::Done<T> ConnectionOrders::Claim(const InterfaceName& required, Done<T> done) {
  if (!busy_.insert(required).second) {
    Reply(std::move(done),
          Result<T>(Error{
              ErrorCode::kFailed,
              ToString(required) +
                  " is being changed by another request; try again when that request is done"}));
    return nullptr;
  }
  return [locked = locked_, required, done = std::move(done)](Result<T> result) {
    locked([&](ConnectionOrders& orders) { orders.busy_.erase(required); });
    done(std::move(result));
  };
}

/// Records the step. Replies when the step is on the disk.
template <typename T>
void ConnectionOrders::Record(message::HistoryEntry step, std::type_identity_t<Result<T>> reply,
                              Done<T> done) {
  step.instance = InstanceOf(parts_.registry.catalogue(), step.ends.required.process);
  step.when = WallTime();
  parts_.history.Record(std::move(step),
                        [reply = std::move(reply), done = std::move(done)] { done(reply); });
}

/// Makes the plan and calls `planned` with it while the lock is held. If the interfaces do not fit,
/// may first ask both processes for schemas. Then the refusal can name the first difference of two
/// types.
void ConnectionOrders::Plan(const message::ConnectionEnds& ends, WhenConnected when_connected,
                            const Planned& planned) {
  static constexpr std::chrono::milliseconds kLongest(400);
  const Catalogue& catalogue = parts_.registry.catalogue();
  const auto plan = PlanConnect(catalogue, ends, when_connected);
  if (plan || plan.error().code != ErrorCode::kIncompatible) return planned(*this, plan);
  const auto missing = std::make_shared<int>(0);  // pending replies; guarded by the lock
  const auto on_reply = [=, locked = locked_] {
    locked([&](ConnectionOrders& orders) {
      if (--*missing > 0) return;
      planned(orders, PlanConnect(orders.parts_.registry.catalogue(), ends, when_connected));
    });
  };
  for (const auto& [process, wanted] : ConflictingTypesBetween(catalogue, ends)) {
    const auto channel = parts_.registry.ChannelOf(process);
    if (channel == nullptr) continue;
    ++*missing;
    parts_.deferred.Add([&worker = parts_.worker, channel, wanted = wanted, on_reply] {
      LearnSchemas(worker, channel, wanted, kLongest, on_reply);
    });
  }
  if (*missing == 0) planned(*this, plan);
}

template <typename Order, typename Outcome>
ConnectionOrders::Done<Outcome> ConnectionOrders::Step(
    std::shared_ptr<Order> order, void (Order::*step)(ConnectionOrders&, const Result<Outcome>&)) {
  return [locked = locked_, order = std::move(order), step](const Result<Outcome>& reply) {
    locked([&](ConnectionOrders& orders) { ((*order).*step)(orders, reply); });
  };
}

void ConnectionOrders::Make(const message::ConnectionEnds& ends, ConnectDone done) {
  std::make_shared<ConnectOrder>(ends, std::move(done))->Start(*this);
}

/// Requests a connection to an absent provider. If the required interface is connected, disconnects
/// it first.
void ConnectionOrders::MakePending(const message::ConnectionEnds& ends, const ConnectDone& done) {
  const auto claimed = Claim(ends.required, done);
  if (!claimed) return;
  const auto make = [locked = locked_, ends, claimed](const Result<None>& broken) {
    if (!broken) return claimed(broken.error());
    locked([&](ConnectionOrders& orders) {
      orders.SendMake(ConnectionPlanOf(orders.parts_.registry.catalogue(), ends), claimed);
    });
  };
  const Catalogue& catalogue = parts_.registry.catalogue();
  if (catalogue.FindConnection(ends.required) != nullptr) return SendBreak(ends.required, make);
  SendMake(ConnectionPlanOf(catalogue, ends), claimed);
}

void ConnectionOrders::Break(const InterfaceName& required, ConnectDone done) {
  const auto connection = PlanDisconnect(parts_.registry.catalogue(), required);
  if (!connection) return Reply(std::move(done), connection);
  const auto claimed = Claim(required, std::move(done));
  if (!claimed) return;
  SendBreak(required, [connection = *connection, claimed](const Result<None>& broken) {
    if (!broken) return claimed(broken.error());
    claimed(connection);
  });
}

void ConnectionOrders::Exchange(const message::ConnectionEnds& ends, const std::string& who,
                                Done<Replacement> done) {
  std::make_shared<ReplaceOrder>(ends, who, std::move(done))->Start(*this);
}

/// Sends the order to make a connection. If no reply arrives, but the process has reported the
/// connection, `done` gets its state from the catalogue.
void ConnectionOrders::SendMake(const message::ConnectionPlan& plan, ConnectDone done) {
  const auto heard = [locked = locked_, ends = plan.ends,
                      done = std::move(done)](Result<ConnectionDescription> made) {
    if (!made && IsOutcomeUnknown(made.error())) {
      locked([&](ConnectionOrders& orders) {
        const auto* now = orders.parts_.registry.catalogue().FindConnection(ends.required);
        if (now != nullptr && now->provided == ends.provided) made = *now;
      });
    }
    done(std::move(made));
  };
  Send<ConnectionDescription>(message::kMakeConnection, plan.ends.required.process, plan, timeout_,
                              heard);
}

void ConnectionOrders::SendBreak(const InterfaceName& required, Done<None> done) {
  const auto heard = [locked = locked_, required, done = std::move(done)](Result<None> broken) {
    bool is_gone = false;
    if (!broken && IsOutcomeUnknown(broken.error())) {
      locked([&](ConnectionOrders& orders) {
        is_gone = orders.parts_.registry.catalogue().FindConnection(required) == nullptr;
      });
    }
    done(is_gone ? None{} : std::move(broken));
  };
  Send<None>(message::kBreakConnection, required.process, message::ConnectionEnds{required, {}},
             timeout_, heard);
}

void ConnectionOrders::UndoLifecycle(const message::HistoryEntry& step,
                                     std::chrono::nanoseconds timeout, const Done<None>& done) {
  const auto connect = [locked = locked_, step](const Done<None>& connected) {
    locked([&](ConnectionOrders& orders) { orders.MakeAgain(step, connected); });
  };
  parts_.lifecycle.Undo(step, timeout, connect, done);
}

/// Restores the connections of a component that was created again. If a connection cannot be
/// restored, `done` gets an error, and the component is not started.
void ConnectionOrders::MakeAgain(const message::HistoryEntry& step, const Done<None>& done) {
  struct Replies {
    std::size_t missing;
    Result<None> outcome;
  };
  const auto replies = std::make_shared<Replies>(
      Replies{1 + step.lifecycle.connections.size(), None{}});  // guarded by the lock
  const auto on_reply = [locked = locked_, done, replies](const message::ConnectionEnds& ends,
                                                          const auto& made) {
    locked([&](ConnectionOrders& orders) {
      const auto* now = orders.parts_.registry.catalogue().FindConnection(ends.required);
      if (!made && (now == nullptr || now->provided != ends.provided)) {
        replies->outcome = Error{ErrorCode::kFailed,
                                 "the component was created again, but not started, because its "
                                 "connections could not be restored: " +
                                     made.error().message};
      }
      if (--replies->missing == 0) orders.Reply(done, replies->outcome);
    });
  };
  for (const message::ConnectionEnds& ends : step.lifecycle.connections) {
    Make(ends, [on_reply, ends](const auto& made) { on_reply(ends, made); });
  }
  Reply<ConnectionDescription>([on_reply](const auto& none) { on_reply({}, none); },
                               ConnectionDescription());
}

/// Checks that the step can be undone. For the start of a process, also asks the supervisor,
/// because the catalogue does not say which processes the GCM has started.
Result<void> ConnectionOrders::CheckUndo(const message::HistoryEntry& step) const {
  auto checked = CheckUndoOf(parts_.registry.catalogue(), parts_.history.steps(), step);
  if (!checked || !IsProcessStep(step)) return checked;
  const auto ours = parts_.supervisor.CheckUndo(step);
  return ours ? ours : CannotUndoNow(step, ours.error().message);
}

void ConnectionOrders::FinishUndo(message::HistoryEntry step, const std::string& who,
                                  const Result<void>& outcome, Done<message::HistoryEntry> done) {
  if (!outcome) {
    return Reply(std::move(done), Result<message::HistoryEntry>(CannotUndo(step, outcome.error())));
  }
  step.undone = true;
  parts_.history.MarkUndone(step.id, [step, done = std::move(done)] { done(step); },
                            {.who = who, .when = WallTime()});
}

void ConnectionOrders::ConnectOrder::Start(ConnectionOrders& orders) {
  orders.Plan(ends_, WhenConnected::kRefuse,
              [self = shared_from_this()](ConnectionOrders& present, const auto& plan) {
                self->OnPlanned(present, plan);
              });
}

void ConnectionOrders::ConnectOrder::OnPlanned(ConnectionOrders& orders,
                                               const Result<message::ConnectionPlan>& plan) {
  if (!plan) return orders.Reply(done_, Result<ConnectionDescription>(plan.error()));
  if (auto claimed = orders.Claim(ends_.required, done_)) orders.SendMake(*plan, claimed);
}

void ConnectionOrders::ReplaceOrder::Start(ConnectionOrders& orders) {
  orders.Plan(ends_, WhenConnected::kReplace,
              [self = shared_from_this()](ConnectionOrders& present, const auto& plan) {
                self->OnPlanned(present, plan);
              });
}

void ConnectionOrders::ReplaceOrder::OnPlanned(ConnectionOrders& orders,
                                               const Result<message::ConnectionPlan>& plan) {
  const Catalogue& catalogue = orders.parts_.registry.catalogue();
  const auto former = plan ? PlanDisconnect(catalogue, ends_.required) : plan.error();
  if (!former) return Fail(orders, former.error());
  auto claimed = orders.Claim(ends_.required, done_);
  if (!claimed) return;
  former_ = *former;
  done_ = std::move(claimed);
  orders.SendBreak(ends_.required, orders.Step(shared_from_this(), &ReplaceOrder::OnBroken));
}

void ConnectionOrders::ReplaceOrder::OnBroken(ConnectionOrders& orders,
                                              const Result<None>& broken) {
  if (!broken) {
    if (IsOutcomeUnknown(broken.error())) return Restore(orders, broken.error());
    return Fail(orders, broken.error());
  }
  orders.SendMake(ConnectionPlanOf(orders.parts_.registry.catalogue(), ends_),
                  orders.Step(shared_from_this(), &ReplaceOrder::OnMade));
}

/// Decides whether the new connection stays. If the old connection was active and the new one is
/// not, restores the old one.
void ConnectionOrders::ReplaceOrder::OnMade(ConnectionOrders& orders,
                                            const Result<ConnectionDescription>& made) {
  if (!made) return Restore(orders, made.error());
  constexpr ConnectionState kActive = ConnectionState::kActive;
  if (made->state == kActive || former_.state != kActive) {
    return orders.Reply(done_, Result(Replacement{*made, former_.provided}));
  }
  Restore(orders, {ErrorCode::kUnreachable,
                   ToString(made->provided) + " was not reached: " + made->reason});
}

/// Removes the new connection, if it exists, and restores the old one. A slow process executes
/// these two orders late, but has the old connection in the end.
void ConnectionOrders::ReplaceOrder::Restore(ConnectionOrders& orders, const Error& why) {
  why_ = why;
  const message::ConnectionEnds former{ends_.required, former_.provided};
  orders.SendBreak(former.required, [](const auto& /*there may be none*/) {});
  orders.Send<ConnectionDescription>(message::kMakeConnection, former.required.process,
                                     ConnectionPlanOf(orders.parts_.registry.catalogue(), former),
                                     orders.timeout_,
                                     orders.Step(shared_from_this(), &ReplaceOrder::OnRestored));
}

/// Reports the failed replacement. If the interface is now disconnected because the old connection
/// could not be restored, records a disconnect, so that it can be undone.
void ConnectionOrders::ReplaceOrder::OnRestored(ConnectionOrders& orders,
                                                const Result<ConnectionDescription>& restored) {
  const message::ConnectionEnds former{ends_.required, former_.provided};
  const std::string required = ToString(former.required);
  const std::string provided = ToString(former.provided);
  Error why = why_;
  if (restored) {
    const bool works = restored->state == ConnectionState::kActive;
    why.message += "; " + required + " is still connected to " + provided +
                   (works ? "" : ", but " + std::string(ToString(restored->state)) + ": ") +
                   restored->reason;
    return Fail(orders, why);
  }
  why.message += restored.error().code == ErrorCode::kTimeout
                     ? "; it is not known yet whether " + required + " is still connected to " +
                           provided + "; see: gcm show " + required
                     : "; " + required + " is not connected to " + provided +
                           " any more, and this connection could not be made again: " +
                           restored.error().message;
  const auto* now = orders.parts_.registry.catalogue().FindConnection(former.required);
  if (now != nullptr) return Fail(orders, why);
  orders.Record({.verb = "disconnect", .ends = former, .who = who_}, why, done_);
}

}  // namespace tendon::server
