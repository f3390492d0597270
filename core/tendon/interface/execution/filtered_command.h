#pragma once

#include <tendon/interface/command.h>

#include <chrono>
#include <memory>
#include <utility>

namespace tendon {

/// Runs `filter` on the argument in the caller's thread, and calls another command with the result.
template <Payload In, Payload Filtered, typename Filter>
class FilteredCommand final : public Command<In, None> {
 public:
  FilteredCommand(Filter filter, std::unique_ptr<Command<Filtered, None>> target)
      : filter_(std::move(filter)), target_(std::move(target)) {}

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

 private:
  template <typename Call>
  Status Convert(const In& in, Call call) {
    typename Scratch<Filtered>::Use filtered(filtered_);
    try {
      filter_(in, *filtered);
    } catch (...) {
      return Status::kFailed;
    }
    return call(*filtered);
  }

  Filter filter_;
  std::unique_ptr<Command<Filtered, None>> target_;
  Scratch<Filtered> filtered_;
};

}  // namespace tendon
