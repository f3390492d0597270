#include <tendon/middleware/large_message_in_progress.h>
#include <tendon/process/ask.h>
#include <tendon/process/watch_over.h>
#include <tendon/proxy/connection_messages.h>

#include <algorithm>
#include <string>

namespace tendon {

bool MayBeHeldUp(const Channel& channel, SteadyTime now, std::chrono::milliseconds silence) {
  return now - std::max(channel.last_part(), LargeMessageInProgress::Last(now)) < silence;
}

void WatchOver(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel,
               const HearTime& hear_time) {
  constexpr std::chrono::milliseconds kBetweenQuestions(500);
  if (!channel->is_open()) return;
  Ask<message::Pong>(
      *worker, channel, message::kPing, None{}, kLongestPeerSilence,
      [weak = std::weak_ptr(channel), hear_time,
       sent = SteadyClock().Now()](const Result<message::Pong>& answer) {
        if (answer && hear_time) {
          hear_time(sent, SteadyTime(std::chrono::nanoseconds(answer->time)), SteadyClock().Now());
        }
        if (answer || answer.error().code != ErrorCode::kTimeout) return;
        const auto silent = weak.lock();
        if (silent && !MayBeHeldUp(*silent, SteadyClock().Now(), kLongestPeerSilence)) {
          silent->CutOff("has not answered for " + std::to_string(kLongestPeerSilence.count()) +
                         " ms");
        }
      },
      kOwnLane);
  worker->PostAfter(kBetweenQuestions, [weak_worker = std::weak_ptr(worker),
                                        weak_channel = std::weak_ptr(channel), hear_time] {
    const auto still_at_work = weak_worker.lock();
    const auto still_there = weak_channel.lock();
    if (still_at_work && still_there) WatchOver(still_at_work, still_there, hear_time);
  });
}

void KeepExpiring(Worker& worker, const std::weak_ptr<Channel>& channel) {
  static constexpr std::chrono::milliseconds kBetween(1000);
  worker.PostAfter(kBetween, [&worker, channel, due = SteadyClock().Now() + kBetween] {
    const auto still_there = channel.lock();
    if (!still_there || !still_there->is_open()) return;
    const SteadyTime now = SteadyClock().Now();
    const bool has_stood_still = now - due > kBetween;  // then received data may be unread
    if (!has_stood_still) still_there->Expire(now);
    KeepExpiring(worker, channel);
  });
}

}  // namespace tendon
