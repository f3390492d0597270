#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace tendon {

/// A peer that sends nothing for a longer time counts as hanging.
inline constexpr std::chrono::milliseconds kLongestPeerSilence(1500);

/// True if the peer's next message may be late because either end sends or handles a large message.
[[nodiscard]] bool MayBeHeldUp(const Channel& channel, SteadyTime now,
                               std::chrono::milliseconds silence);

/// Called in a thread of the middleware. `sent` and `arrived` are the times of a request and its
/// reply on the clock of this process. `there` is the time of the peer's steady clock in between.
using OnPeerTime = std::function<void(SteadyTime sent, SteadyTime there, SteadyTime arrived)>;

/// Pings the process at the other end twice a second while the channel is open. Closes the channel
/// after 1.5 s without a reply, because a process that hangs or is cut off does not close it.
/// Waits longer while large messages are sent or handled, because they may delay the reply.
/// `worker` provides the timer.
void MonitorPeer(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel,
                 const OnPeerTime& on_peer_time = nullptr);

/// Calls Channel::Expire() every second on `worker` while the channel is open. For the side that
/// has accepted a channel. This side sends no requests, so nothing else checks its timeouts.
void KeepExpiring(Worker& worker, const std::weak_ptr<Channel>& channel);

/// Closes the channel of a viewer that hangs, so that the process does not send rows to it forever.
/// A viewer pings twice a second. After its first ping, a silence of 1.5 s closes the channel and
/// ends its subscriptions. A viewer that was only slow opens the channel again and counts the
/// missed rows.
class ViewerMonitor final : public std::enable_shared_from_this<ViewerMonitor> {
 public:
  explicit ViewerMonitor(std::weak_ptr<Worker> worker) : worker_(std::move(worker)) {}

  /// Records a ping. Any thread; wait-free.
  void OnPing() noexcept { last_ping_.Set(SteadyClock().Now()); }
  /// Starts checking on the worker while the channel is open. Further calls do nothing. Called by
  /// one thread.
  void Begin(const std::shared_ptr<Channel>& channel);

 private:
  void CheckAfter(std::chrono::milliseconds delay);
  void Check(SteadyTime due);

  const std::weak_ptr<Worker> worker_;
  std::weak_ptr<Channel> channel_;  // used only on the worker after Begin()
  bool has_begun_ = false;
  Published<SteadyTime> last_ping_;
};

}  // namespace tendon
