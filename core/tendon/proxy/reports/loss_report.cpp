#include <tendon/proxy/reports/loss_report.h>

#include <algorithm>
#include <chrono>

namespace tendon {

void LossReport::Set(std::size_t handler, std::uint64_t lost) {
  if (handler >= lost_.lost.size()) lost_.lost.resize(handler + 1);
  is_news_ = is_news_ || lost_.lost[handler] != lost;
  lost_.lost[handler] = lost;
}

void LossReport::Tell(SteadyTime now, SteadyTime& next) {
  constexpr std::chrono::milliseconds kBetweenReports(20);
  if (!is_news_) return;
  if (now >= earliest_) {
    earliest_ = now + kBetweenReports;
    is_news_ = channel_->Notify(message::kEventsLost, handle_, lost_) == Status::kQueueFull;
  }
  if (is_news_) next = std::min(next, earliest_);
}

}  // namespace tendon
