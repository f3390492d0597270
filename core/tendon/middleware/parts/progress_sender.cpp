#include <tendon/base/clock.h>
#include <tendon/middleware/parts/large_message_in_progress.h>
#include <tendon/middleware/parts/progress_sender.h>
#include <tendon/middleware/requests/pending_requests.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <utility>

namespace tendon {

ProgressSender::ProgressSender(const std::string& peer, std::function<void()> give) {
  CallGuarded(peer, [&] {
    thread_ = std::jthread([give = std::move(give)](const std::stop_token& stop) {
      constexpr std::chrono::milliseconds kBetween(250);
      std::mutex mutex;
      std::condition_variable_any never;
      std::unique_lock lock(mutex);
      const SteadyTime end = SteadyClock().Now() + LargeMessageInProgress::kAtMost;
      while (!never.wait_for(lock, stop, kBetween, [&] { return stop.stop_requested(); }) &&
             SteadyClock().Now() < end) {
        give();
      }
    });
  });
}

}  // namespace tendon
