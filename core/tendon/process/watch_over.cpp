#include <tendon/process/ask.h>
#include <tendon/process/watch_over.h>
#include <tendon/proxy/messages.h>

namespace tendon {

void WatchOver(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel,
               const HearTime& hear_time) {
  constexpr std::chrono::milliseconds kBetweenQuestions(500);
  constexpr std::chrono::milliseconds kSilence(1500);
  if (!channel->is_open()) return;
  Ask<message::Pong>(
      *worker, channel, message::kPing, None{}, kSilence,
      [weak = std::weak_ptr(channel), hear_time,
       sent = SteadyClock().Now()](const Result<message::Pong>& answer) {
        if (answer && hear_time) {
          hear_time(sent, SteadyTime(std::chrono::nanoseconds(answer->time)), SteadyClock().Now());
        }
        if (answer || answer.error().code != ErrorCode::kTimeout) return;
        if (const auto silent = weak.lock()) silent->Close();
      },
      kOwnLane);
  worker->PostAfter(kBetweenQuestions, [weak_worker = std::weak_ptr(worker),
                                        weak_channel = std::weak_ptr(channel), hear_time] {
    const auto still_at_work = weak_worker.lock();
    const auto still_there = weak_channel.lock();
    if (still_at_work && still_there) WatchOver(still_at_work, still_there, hear_time);
  });
}

}  // namespace tendon
