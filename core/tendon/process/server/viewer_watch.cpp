#include <tendon/process/server/viewer_watch.h>
#include <tendon/process/watch_over.h>

#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks(500);

}  // namespace

void ViewerWatch::Begin(const std::shared_ptr<Channel>& channel) {
  if (std::exchange(has_begun_, true)) return;
  channel_ = channel;
  LookAfter(kBetweenLooks);
}

void ViewerWatch::LookAfter(std::chrono::milliseconds delay) {
  const auto worker = worker_.lock();
  if (!worker) return;
  const SteadyTime due = SteadyClock().Now() + delay;
  worker->PostAfter(delay, [weak = weak_from_this(), due] {
    if (const auto self = weak.lock()) self->Look(due);
  });
}

void ViewerWatch::Look(SteadyTime due) {
  const auto channel = channel_.lock();
  if (!channel || !channel->is_open()) return;
  const SteadyTime heard = heard_.Get();
  if (heard == SteadyTime{}) return LookAfter(kBetweenLooks);  // the peer has not pinged yet
  const SteadyTime now = SteadyClock().Now();
  const SteadyTime end = heard + kLongestPeerSilence;
  if (now < end) return LookAfter(std::min(kBetweenLooks, TimeUntil(end)));
  // A late check may mean that this process was suspended and has unread pings. Checks are frequent
  // enough that a shorter pause cannot hide three pings.
  const bool is_late = now - due > kBetweenLooks;
  if (is_late || MayBeHeldUp(*channel, now, kLongestPeerSilence)) return LookAfter(kBetweenLooks);
  channel->Close();
}

}  // namespace tendon
