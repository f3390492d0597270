#include <tendon/base/log.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/server/orders.h>
#include <tendon/gcm/text/wall_time.h>
#include <tendon/process/ask.h>

#include <utility>

namespace tendon::server {
namespace {

void LogHandBack(const message::Wire& wire, const Result<void>& outcome,
                 HandBacks::Verdict verdict) {
  const std::string what = ToString(wire.required) + " to " + ToString(wire.provided);
  if (outcome) return Log(LogLevel::kInfo, "gcm", "connected again: " + what);
  const bool is_told = verdict == HandBacks::Verdict::kStillTrying;
  if (is_told || outcome.error().code == ErrorCode::kExists) return;  // the process did it itself
  const bool is_over = verdict == HandBacks::Verdict::kGivenUp;
  Log(LogLevel::kWarning, "gcm",
      "cannot connect again " + what + ": " + outcome.error().message +
          (is_over ? "" : "; trying again"));
}

}  // namespace

Orders::Orders(Parts parts, Locked locked, std::chrono::milliseconds timeout)
    : parts_(parts), locked_(std::move(locked)), timeout_(timeout) {}

void Orders::Connect(const message::Wire& wire, const std::string& who, ConnectDone done) {
  Make(wire, [locked = locked_, wire, who, done = std::move(done)](const auto& made) {
    if (!made) return done(made);
    locked([&](Orders& orders) { orders.Record("connect", wire, who, *made, done); });
  });
}

void Orders::Disconnect(const InterfaceName& required, const std::string& who, Done<None> done) {
  Break(required, [locked = locked_, who, done = std::move(done)](const auto& broken) {
    if (!broken) return done(broken.error());
    const message::Wire wire{broken->required, broken->provided};
    locked([&](Orders& orders) { orders.Record("disconnect", wire, who, None{}, done); });
  });
}

void Orders::Undo(Done<message::HistoryEntry> done) {
  const auto step = parts_.history.last();
  if (!step)
    return Answer(std::move(done), Result<message::HistoryEntry>(
                                       Error{ErrorCode::kFailed, "there is nothing to undo"}));
  if (const auto checked = CheckUndo(*step); !checked) {
    return Answer(std::move(done), Result<message::HistoryEntry>(checked.error()));
  }
  const ConnectDone finish = [locked = locked_, step = *step,
                              done = std::move(done)](const auto& outcome) {
    locked([&](Orders& orders) { orders.FinishUndo(step, outcome, done); });
  };
  if (step->verb == "connect") {
    Break(step->wire.required, finish);
  } else {
    Make(step->wire, finish);
  }
}

void Orders::HandBack(const message::Wire& wire) {
  Make(wire, [locked = locked_, wire](const auto& made) {
    const Result<void> outcome = made ? Result<void>() : made.error();
    auto verdict = HandBacks::Verdict::kStillTrying;
    locked([&](Orders& orders) { verdict = orders.parts_.registry.SettleHandBack(wire, outcome); });
    LogHandBack(wire, outcome, verdict);
  });
}

template <typename T>
void Orders::Answer(Done<T> done, Result<T> result) {
  parts_.outbox.Add([done = std::move(done), result = std::move(result)] { done(result); });
}

/// Sends the order to the required side's LCM, one at a time for an interface.
template <typename T, Message Body>
void Orders::Give(MessageType type, const InterfaceName& required, const Body& body, Done<T> done) {
  const auto channel = parts_.registry.ChannelOf(required.process);
  if (!channel) {
    return Answer(
        std::move(done),
        Result<T>(Error{ErrorCode::kFailed, "process '" + required.process + "' is not there"}));
  }
  if (!busy_.insert(required).second) {
    return Answer(std::move(done),
                  Result<T>(Error{ErrorCode::kFailed, ToString(required) +
                                                          " is being changed by another request; "
                                                          "try again when that is done"}));
  }
  auto finish = [locked = locked_, required, done = std::move(done)](Result<T> result) {
    locked([&](Orders& orders) { orders.busy_.erase(required); });
    done(std::move(result));
  };
  parts_.outbox.Add(
      [&worker = parts_.worker, channel, type, body, timeout = timeout_,
       finish = std::move(finish)] { Ask<T>(worker, channel, type, body, timeout, finish); });
}

/// Answers once the step is kept.
template <typename T>
void Orders::Record(const std::string& verb, const message::Wire& wire, const std::string& who,
                    T answer, Done<T> done) {
  parts_.history.Record({.verb = verb, .wire = wire, .who = who, .when = WallTime()},
                        [answer = std::move(answer), done = std::move(done)] { done(answer); });
}

void Orders::Make(const message::Wire& wire, ConnectDone done) {
  const auto wiring = PlanConnect(parts_.registry.catalog(), wire);
  if (!wiring) return Answer(std::move(done), Result<ConnectionDescription>(wiring.error()));
  Give<ConnectionDescription>(message::kMakeConnection, wire.required, *wiring, std::move(done));
}

void Orders::Break(const InterfaceName& required, ConnectDone done) {
  const auto connection = PlanDisconnect(parts_.registry.catalog(), required);
  if (!connection) return Answer(std::move(done), connection);
  Give<None>(message::kBreakConnection, required, message::Wire{required, {}},
             [connection = *connection, done = std::move(done)](const Result<None>& result) {
               if (!result) return done(result.error());
               done(connection);
             });
}

/// Whether the objects are still as the step left them.
Result<void> Orders::CheckUndo(const message::HistoryEntry& step) const {
  const auto* now = parts_.registry.catalog().FindConnection(step.wire.required);
  const std::string required = ToString(step.wire.required);
  if (step.verb == "connect" && now == nullptr) {
    return Error{ErrorCode::kFailed, "cannot undo: " + required + " is no longer connected to " +
                                         ToString(step.wire.provided)};
  }
  const bool changed =
      step.verb == "connect" ? now->provided != step.wire.provided : now != nullptr;
  if (!changed) return {};
  return Error{ErrorCode::kFailed,
               "cannot undo: " + required + " was since connected to " + ToString(now->provided)};
}

void Orders::FinishUndo(message::HistoryEntry step, const Result<ConnectionDescription>& outcome,
                        Done<message::HistoryEntry> done) {
  if (!outcome) {
    const Error error{outcome.error().code, "cannot undo: " + outcome.error().message};
    return Answer(std::move(done), Result<message::HistoryEntry>(error));
  }
  step.undone = true;
  parts_.history.MarkUndone(step.id, [step, done = std::move(done)] { done(step); });
}

}  // namespace tendon::server
