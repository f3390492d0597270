#pragma once

#include <tendon/base/clock.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <memory>

namespace tendon {

/// A peer with a longer silence counts as hanging.
inline constexpr std::chrono::milliseconds kLongestPeerSilence(1500);

/// True if a large message, at either end, may delay the peer's next message.
[[nodiscard]] bool MayBeHeldUp(const Channel& channel, SteadyTime now,
                               std::chrono::milliseconds silence);

/// Called in a thread of the middleware with the times of a request and its answer on our clock,
/// and the time of the peer's steady clock in between.
using HearTime = std::function<void(SteadyTime sent, SteadyTime there, SteadyTime arrived)>;

/// Pings the process at the other end twice a second while the channel is open. Closes the channel
/// after 1.5 s without an answer, because a process that hangs or is cut off does not close it.
/// Waits longer while large messages are being sent or handled, because they may delay the answer.
/// `worker` provides the timer.
void WatchOver(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel,
               const HearTime& hear_time = nullptr);

/// Calls Channel::Expire() every second on `worker` while the channel is open. For the acceptor of
/// a channel, which sends no requests itself.
void KeepExpiring(Worker& worker, const std::weak_ptr<Channel>& channel);

}  // namespace tendon
