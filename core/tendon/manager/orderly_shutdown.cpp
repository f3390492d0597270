#include <tendon/manager/orderly_shutdown.h>

#include <tendon/base/log.h>
#include <tendon/interface/execution/block_when_full.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>
#include <utility>

namespace tendon {

OrderlyShutdown::OrderlyShutdown(std::vector<Member> members, Actions actions)
    : members_(std::move(members)),
      actions_(std::move(actions)),
      phases_(members_.size(), Phase::kWaits),
      drained_by_(members_.size()) {}

Result<void> OrderlyShutdown::Run(SteadyTime deadline) {
  const BlockWhenFull all_together;  // one time limit for all components that this thread stops
  while (!Advance()) {
    if (SteadyClock().Now() >= deadline) {
      GiveUp();
      break;
    }
    Wait();
  }
  return outcome_;
}

/// Returns true if all components have ended.
bool OrderlyShutdown::Advance() {
  for (std::size_t place = 0; place < members_.size(); ++place) Advance(place);
  return std::ranges::all_of(phases_, [](Phase phase) { return phase == Phase::kDone; });
}

void OrderlyShutdown::Advance(std::size_t place) {
  const Member& member = members_[place];
  Phase& phase = phases_[place];
  if (phase == Phase::kWaits) {
    const auto is_done = [this](std::size_t other) { return phases_[other] == Phase::kDone; };
    if (std::ranges::all_of(member.before, is_done)) RequestStop(place);
  }
  if (phase == Phase::kRequested && member.component->is_at_rest()) {
    RecordResult(member.component->WaitForEffect(ComponentState::kFinished, kNoWait));
    BeginDrain(place);
  }
  if (phase != Phase::kEnded) return;
  const bool is_drained = !actions_.has_calls_under_way(*member.component);
  if (!is_drained && SteadyClock().Now() < drained_by_[place]) return;
  if (!is_drained) LogNotExecuted(*member.component);
  phase = Phase::kDone;
}

void OrderlyShutdown::RequestStop(std::size_t place) {
  const auto& component = members_[place].component;
  Phase& phase = phases_[place];
  if (actions_.is_at_rest(*component)) return BeginDrain(place);
  const auto asked = actions_.stop(component);
  if (asked || component->is_stopping()) {
    phase = Phase::kRequested;
  } else if (asked.error().code != ErrorCode::kTimeout) {
    RecordResult(asked);
    BeginDrain(place);
  }
}

void OrderlyShutdown::BeginDrain(std::size_t place) {
  phases_[place] = Phase::kEnded;
  drained_by_[place] = SteadyClock().Now() + kLastCallsTimeout;
}

/// Waits a short time. Calls WaitFor(), because it also does the work of components without a
/// thread.
void OrderlyShutdown::Wait() {
  constexpr std::chrono::microseconds kBetweenLooks(500);
  bool has_waited = false;
  for (std::size_t place = 0; place < members_.size(); ++place) {
    if (phases_[place] != Phase::kRequested) continue;
    (void)members_[place].component->WaitFor(ComponentState::kFinished, kBetweenLooks);
    has_waited = true;
  }
  if (!has_waited) std::this_thread::sleep_for(kBetweenLooks);
}

void OrderlyShutdown::GiveUp() {
  for (std::size_t place = 0; place < members_.size(); ++place) {
    if (phases_[place] == Phase::kEnded) LogNotExecuted(*members_[place].component);
    if (phases_[place] == Phase::kWaits) RequestStop(place);
  }
  const auto is_at_rest = [this](const Member& member) {
    return actions_.is_at_rest(*member.component);
  };
  const SteadyTime last = SteadyClock().Now() + kGrace;
  while (!std::ranges::all_of(members_, is_at_rest) && SteadyClock().Now() < last) Wait();
  for (const Member& member : members_) {
    if (is_at_rest(member)) continue;
    const Component& component = *member.component;
    RecordResult(Error{ErrorCode::kTimeout, "component '" + component.name() + "' is still " +
                                                std::string(ToString(component.state())) +
                                                ", not finished; it may be busy in one of its own "
                                                "functions"});
  }
}

void OrderlyShutdown::LogNotExecuted(const Component& client) {
  Log(LogLevel::kWarning, client.name(),
      "has stopped, but some of its last calls were not executed in time: the server of these "
      "calls is busy, or does not answer");
}

void OrderlyShutdown::RecordResult(const Result<void>& result) {
  if (outcome_) outcome_ = result;
}

}  // namespace tendon
