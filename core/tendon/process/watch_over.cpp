#include <tendon/process/ask.h>
#include <tendon/process/watch_over.h>
#include <tendon/proxy/messages.h>

namespace tendon {

void WatchOver(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel) {
  constexpr std::chrono::milliseconds kBetweenQuestions(500);
  constexpr std::chrono::milliseconds kSilence(1500);
  if (!channel->is_open()) return;
  Ask<None>(*worker, channel, message::kPing, None{}, kSilence,
            [weak = std::weak_ptr(channel)](const Result<None>& answer) {
              if (answer || answer.error().code != ErrorCode::kTimeout) return;
              if (const auto silent = weak.lock()) silent->Close();
            });
  worker->PostAfter(kBetweenQuestions,
                    [weak_worker = std::weak_ptr(worker), weak_channel = std::weak_ptr(channel)] {
                      const auto still_at_work = weak_worker.lock();
                      const auto still_there = weak_channel.lock();
                      if (still_at_work && still_there) WatchOver(still_at_work, still_there);
                    });
}

}  // namespace tendon
