#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/execution/call_observer.h>

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>

namespace tendon {

/// Runs `filter` on the argument in the caller's thread, and calls another command with the result.
/// Observers of `offer`, which may be null, see the argument of the caller, and whether the call
/// was queued or refused.
template <Payload In, Payload Filtered, typename Filter>
class FilteredCommand final : public Command<In, None> {
 public:
  FilteredCommand(Filter filter, std::unique_ptr<Command<Filtered, None>> target,
                  const CallSwitches* offer = nullptr)
      : filter_(std::move(filter)), target_(std::move(target)), observer_(offer) {}

  Status Execute(const In& in, None& out) override {
    return Convert(in, [&](const Filtered& filtered) { return target_->Execute(filtered, out); });
  }
  Status Wait(const In& in, None& out, std::chrono::nanoseconds timeout) override {
    return Convert(in,
                   [&](const Filtered& filtered) { return target_->Wait(filtered, out, timeout); });
  }
  Status Begin(const In& in, None& out, Wakeup<>& ended, std::size_t& call) override {
    return Convert(
        in, [&](const Filtered& filtered) { return target_->Begin(filtered, out, ended, call); });
  }
  [[nodiscard]] bool HasEnded(std::size_t call) override { return target_->HasEnded(call); }
  Status End(std::size_t call, None& out) override { return target_->End(call, out); }

  void SetClient(const std::shared_ptr<const std::string>& client) override {
    observer_.SetClient(client);
  }

 private:
  template <typename Call>
  Status Convert(const In& in, Call call) {
    typename Scratch<Filtered>::Use filtered(filtered_);
    try {
      filter_(in, *filtered);
    } catch (...) {
      return observer_.ShowOther(CallOutcome::kFailed, Status::kFailed, in);
    }
    const Status status = call(*filtered);
    return observer_.ShowOther(OutcomeOf(status), status, in);
  }
  static CallOutcome OutcomeOf(Status status) {
    switch (status.code()) {
      case Status::kDone:
        return CallOutcome::kExecuted;
      case Status::kQueued:
      case Status::kOutcomeUnknown:
        return CallOutcome::kQueued;
      case Status::kTimeout:
        return CallOutcome::kExpired;
      case Status::kFailed:
        return CallOutcome::kFailed;
      default:
        return CallOutcome::kRefused;
    }
  }

  Filter filter_;
  std::unique_ptr<Command<Filtered, None>> target_;
  Scratch<Filtered> filtered_;
  CallObserver observer_;
};

}  // namespace tendon
