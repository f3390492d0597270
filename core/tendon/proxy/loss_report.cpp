#include <tendon/proxy/loss_report.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tendon {

void LossReport::Set(std::size_t handler, std::uint64_t lost) {
  if (handler >= lost_.size()) {
    lost_.resize(handler + 1);
    told_.lost.resize(handler + 1);
  }
  lost_[handler] = lost;
}

void LossReport::Tell(SteadyTime now, SteadyTime& next) {
  constexpr std::chrono::milliseconds kBetweenReports(20);
  if (lost_ == told_.lost) return;
  if (now >= earliest_) {
    earliest_ = now + kBetweenReports;
    message::EventsLost report = told_;
    for (std::size_t i = 0; i < lost_.size(); ++i) {
      report.lost[i] += std::min(lost_[i] - told_.lost[i], message::EventsLost::kMostAtOnce);
    }
    const Status sent = channel_->Notify(message::kEventsLost, handle_, report);
    if (sent != Status(Status::kQueueFull)) told_ = std::move(report);
  }
  if (lost_ != told_.lost) next = std::min(next, earliest_);
}

}  // namespace tendon
