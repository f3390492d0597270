#include <tendon/process/heartbeat.h>

#include <tendon/base/text.h>
#include <tendon/middleware/large_message_in_progress.h>
#include <tendon/process/ask.h>
#include <tendon/proxy/connection_messages.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::milliseconds kBetweenChecks(500);

}  // namespace

bool MayBeHeldUp(const Channel& channel, SteadyTime now, std::chrono::milliseconds silence) {
  return now - std::max(channel.last_part(), LargeMessageInProgress::Last(now)) < silence;
}

void MonitorPeer(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel,
                 const OnPeerTime& on_peer_time) {
  constexpr std::chrono::milliseconds kBetweenQuestions(500);
  if (!channel->is_open()) return;
  Ask<message::Pong>(
      *worker, channel, message::kPing, None{}, kLongestPeerSilence,
      [weak = std::weak_ptr(channel), on_peer_time,
       sent = SteadyClock().Now()](const Result<message::Pong>& reply) {
        if (reply && on_peer_time) {
          on_peer_time(sent, SteadyTime(std::chrono::nanoseconds(reply->time)),
                       SteadyClock().Now());
        }
        if (reply || reply.error().code != ErrorCode::kTimeout) return;
        const auto silent = weak.lock();
        if (silent && !MayBeHeldUp(*silent, SteadyClock().Now(), kLongestPeerSilence)) {
          silent->CutOff("has not answered for " + Milliseconds(kLongestPeerSilence));
        }
      },
      kOwnLane);
  worker->PostAfter(kBetweenQuestions, [weak_worker = std::weak_ptr(worker),
                                        weak_channel = std::weak_ptr(channel), on_peer_time] {
    const auto still_at_work = weak_worker.lock();
    const auto still_there = weak_channel.lock();
    if (still_at_work && still_there) MonitorPeer(still_at_work, still_there, on_peer_time);
  });
}

void KeepExpiring(Worker& worker, const std::weak_ptr<Channel>& channel) {
  static constexpr std::chrono::milliseconds kBetween(1000);
  worker.PostAfter(kBetween, [&worker, channel, due = SteadyClock().Now() + kBetween] {
    const auto still_there = channel.lock();
    if (!still_there || !still_there->is_open()) return;
    const SteadyTime now = SteadyClock().Now();
    const bool has_stood_still = now - due > kBetween;  // if true, received data may be unread
    if (!has_stood_still) still_there->Expire(now);
    KeepExpiring(worker, channel);
  });
}

void ViewerMonitor::Begin(const std::shared_ptr<Channel>& channel) {
  if (std::exchange(has_begun_, true)) return;
  channel_ = channel;
  CheckAfter(kBetweenChecks);
}

void ViewerMonitor::CheckAfter(std::chrono::milliseconds delay) {
  const auto worker = worker_.lock();
  if (!worker) return;
  const SteadyTime due = SteadyClock().Now() + delay;
  worker->PostAfter(delay, [weak = weak_from_this(), due] {
    if (const auto self = weak.lock()) self->Check(due);
  });
}

void ViewerMonitor::Check(SteadyTime due) {
  const auto channel = channel_.lock();
  if (!channel || !channel->is_open()) return;
  const SteadyTime last_ping = last_ping_.Get();
  if (last_ping == SteadyTime{}) return CheckAfter(kBetweenChecks);  // the peer has not pinged yet
  const SteadyTime now = SteadyClock().Now();
  const SteadyTime end = last_ping + kLongestPeerSilence;
  if (now < end) return CheckAfter(std::min(kBetweenChecks, TimeUntil(end)));
  // A late check may mean that this process was suspended and has not yet read the pings. The
  // checks are frequent: a pause that is too short to delay a check is also too short for three
  // missing pings.
  const bool is_late = now - due > kBetweenChecks;
  if (is_late || MayBeHeldUp(*channel, now, kLongestPeerSilence)) return CheckAfter(kBetweenChecks);
  channel->Close();
}

}  // namespace tendon
