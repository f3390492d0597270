#include <tendon/gcm/life/life_orders.h>
#include <tendon/gcm/life/life_plan.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text/wall_time.h>
#include <tendon/process/ask.h>

#include <algorithm>

namespace tendon::server {
namespace {

using message::LifeOrder;
using message::LifeOutcome;
using std::chrono::milliseconds;

std::string PathOf(const LifeOrder& order) {
  return order.component.empty() ? order.process : order.process + "/" + order.component;
}

std::string ObjectOf(const LifeOrder& order) {
  return order.component.empty() ? "'" + order.library + "'" : PathOf(order);
}

bool IsSilence(const Error& error) {
  return error.code == ErrorCode::kTimeout || error.code == ErrorCode::kUnreachable;
}

Error Void(const LifeOrder& order) {
  return {ErrorCode::kFailed, "process '" + order.process + "' has not begun in time to " +
                                  std::string(ToString(order.verb)) + " " + ObjectOf(order) +
                                  ": nothing was done, and will not be"};
}

Error Unknown(const LifeOrder& order, const Error& why) {
  const std::string known = "; outcome unknown";
  return {ErrorCode::kTimeout, why.message + (why.message.ends_with(known) ? "" : known) +
                                   "; see: gcm show " + PathOf(order)};
}

}  // namespace

LifeOrders::LifeOrders(Parts parts, Locked locked, milliseconds timeout)
    : parts_(parts), locked_(std::move(locked)), timeout_(timeout) {}

void LifeOrders::Steer(const LifeOrder& order, const std::string& who, Done<None> done) {
  const Catalog& catalog = parts_.registry.catalog();
  const Path path{order.process, order.component};
  const bool is_stop = order.verb == LifeVerb::kStop;
  if (is_stop) PassOnStop(path);
  if (auto checked = CheckTarget(catalog, order); !checked) {
    return Answer(std::move(done), Result<None>(checked.error()));
  }
  const auto claimed = is_stop ? std::move(done) : Claim(path, std::move(done));
  if (!claimed) return;
  message::HistoryEntry entry{.verb = std::string(ToString(order.verb)),
                              .life = StepOf(catalog, order),
                              .who = who,
                              .instance = InstanceOf(catalog, order.process)};
  GiveOrder(order, [locked = locked_, entry = std::move(entry), claimed](const auto& outcome) {
    locked([&](LifeOrders& self) { self.Record(entry, outcome, claimed); });
  });
}

/// What was done, or may have been, is a step; answers once it is kept.
void LifeOrders::Record(message::HistoryEntry entry, const Result<LifeOutcome>& outcome,
                        const Done<None>& done) {
  Result<None> answer = outcome ? Result<None>(None{}) : outcome.error();
  if (outcome && !outcome->warning.empty()) {
    answer = Error{ErrorCode::kFailed, "done, but: " + outcome->warning};
  }
  entry.is_unknown = !outcome && IsSilence(outcome.error());
  const bool is_step = !entry.life.process.empty() && (outcome || entry.is_unknown);
  if (!is_step) return Answer(done, answer);
  if (outcome) AddOutcome(*outcome, entry.life);
  entry.when = WallTime();
  parts_.history.Record(std::move(entry), [done, answer] { done(answer); });
}

void LifeOrders::Undo(const message::HistoryEntry& step, std::chrono::nanoseconds patience,
                      Connect connect, Done<None> done) {
  const message::LifeStep& life = step.life;
  const auto checked = CheckUndo(parts_.registry.catalog(), step);
  if (!checked) return Answer(std::move(done), Result<None>(checked.error()));
  const auto claimed = Claim({life.process, life.component}, std::move(done));
  if (!claimed) return;
  UndoPlan plan = PlanUndo(step, patience);
  const auto start = [locked = locked_, then = std::move(plan.then),
                      claimed](const auto& connected) {
    if (!connected || then.empty()) return claimed(connected);
    locked([&](LifeOrders& self) { self.GiveAll(then, claimed); });
  };
  GiveAll(std::move(plan.first),
          [connect = std::move(connect), start, claimed](const auto& done_so_far) {
            if (!done_so_far) return claimed(done_so_far);
            connect(start);
          });
}

Result<void> LifeOrders::Begin(std::uint64_t order, const std::string& by) {
  const auto found = given_.find(order);
  if (found == given_.end() || found->second.path.first != by || found->second.is_void) {
    return Error{ErrorCode::kFailed, "the order is void: nobody waits for it any more"};
  }
  found->second.is_begun = true;
  return {};
}

void LifeOrders::ListClasses(const std::string& process, Done<message::Classes> done) {
  using message::Classes;
  const auto entry = LookUpProcess(parts_.registry.catalog(), process);
  if (!entry) return Answer(std::move(done), Result<Classes>(entry.error()));
  if (auto present = RequirePresent((*entry)->process); !present) {
    return Answer(std::move(done), Result<Classes>(present.error()));
  }
  Give<Classes>(message::kGetClasses, process, message::GetClasses{process}, timeout_,
                std::move(done));
}

template <typename T>
void LifeOrders::Answer(Done<T> done, Result<T> result) {
  parts_.outbox.Add([done = std::move(done), result = std::move(result)] { done(result); });
}

/// `done`, which also lets the next order to the component in; null where one is under way.
LifeOrders::Done<None> LifeOrders::Claim(const Path& path, Done<None> done) {
  if (path.second.empty()) return done;  // the process takes one after the other
  if (!busy_.emplace(path, false).second) {
    Answer(std::move(done),
           Result<None>(Error{ErrorCode::kFailed, path.first + "/" + path.second +
                                                      " is being changed by another request; try "
                                                      "again when that is done"}));
    return nullptr;
  }
  return [locked = locked_, path, done = std::move(done)](Result<None> result) {
    locked([&](LifeOrders& self) { self.busy_.erase(path); });
    done(std::move(result));
  };
}

/// What is on its way to the component and could let it run does so no more.
void LifeOrders::PassOnStop(const Path& path) {
  const auto claim = busy_.find(path);
  if (claim != busy_.end()) claim->second = true;
  for (auto& [id, given] : given_) {
    const bool starts = given.verb == LifeVerb::kStart || given.verb == LifeVerb::kRestart;
    if (given.path == path && starts && !given.is_begun) given.is_void = true;
  }
}

template <typename T, Message Body>
void LifeOrders::Give(MessageType type, const std::string& process, const Body& body,
                      milliseconds longest, Done<T> done) {
  const auto channel = parts_.registry.ChannelOf(process);
  if (!channel) {
    return Answer(std::move(done),
                  Result<T>(Error{ErrorCode::kFailed, "process '" + process + "' is not there"}));
  }
  parts_.outbox.Add(
      [&worker = parts_.worker, channel, type, body, longest, done = std::move(done)] {
        Ask<T>(worker, channel, type, body, longest, done);
      });
}

void LifeOrders::GiveOrder(LifeOrder order, LifeDone done) {
  if (auto checked = CheckTarget(parts_.registry.catalog(), order); !checked) {
    return Answer(std::move(done), Result<LifeOutcome>(checked.error()));
  }
  if (order.patience <= milliseconds(0)) order.patience = timeout_ * 2 / 3;
  order.patience = std::min<std::chrono::nanoseconds>(order.patience, std::chrono::hours(1));
  order.id = ++last_id_;
  given_[order.id] = {.path = {order.process, order.component}, .verb = order.verb};
  const auto heard = [locked = locked_, order, done = std::move(done)](Result<LifeOutcome> obeyed) {
    bool is_begun = true;  // as far as is known
    locked([&](LifeOrders& self) { is_begun = self.given_.extract(order.id).mapped().is_begun; });
    if (!obeyed && IsSilence(obeyed.error())) {
      obeyed = is_begun ? Unknown(order, obeyed.error()) : Void(order);
    }
    done(std::move(obeyed));
  };
  // Before the one who asked gives up, who waits twice as long as it may take.
  const auto patience = std::chrono::ceil<milliseconds>(order.patience);
  const milliseconds longest = patience + std::min(timeout_, patience / 2);
  Give<LifeOutcome>(message::kLife, order.process, order, longest, heard);
}

/// One after the other, up to the first that fails. One that is to rest after its start, and does
/// not, is stopped.
void LifeOrders::GiveAll(std::vector<LifeOrder> orders, Done<None> done) {
  if (orders.empty()) return Answer(std::move(done), Result<None>(None{}));
  const LifeOrder first = orders.front();
  const auto claim = busy_.find({first.process, first.component});
  if (first.verb == LifeVerb::kStart && claim != busy_.end() && claim->second) {
    return Answer(
        std::move(done),
        Result<None>(Error{ErrorCode::kFailed, PathOf(first) + " was ordered to stop meanwhile, so "
                                                               "it is not started"}));
  }
  orders.erase(orders.begin());
  GiveOrder(first, [locked = locked_, rest = std::move(orders), first,
                    done](const Result<LifeOutcome>& obeyed) {
    if (!obeyed) return done(obeyed.error());
    if (rest.empty()) return done(None{});
    locked([&](LifeOrders& self) {
      if (first.verb != LifeVerb::kStart) return self.GiveAll(rest, done);
      self.GiveAll(rest, [locked = self.locked_, first, done](const Result<None>& rests) {
        if (rests) return done(rests);
        LifeOrder stop = first;
        stop.verb = LifeVerb::kStop;
        locked([&](LifeOrders& again) {
          again.GiveOrder(stop, [done, rests](const auto& /*stopped*/) { done(rests); });
        });
      });
    });
  });
}

}  // namespace tendon::server
