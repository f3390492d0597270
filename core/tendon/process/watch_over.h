#pragma once

#include <tendon/base/clock.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <memory>

namespace tendon {

/// A peer that is silent for this long counts as hanging.
inline constexpr std::chrono::milliseconds kLongestPeerSilence(1500);

/// Whether a large message, at either end, may delay the peer's next message.
[[nodiscard]] bool MayBeHeldUp(const Channel& channel, SteadyTime now,
                               std::chrono::milliseconds silence);

/// Called with the times of a request and its answer on our clock, and the peer's steady clock in
/// between. In a thread of the middleware.
using HearTime = std::function<void(SteadyTime sent, SteadyTime there, SteadyTime arrived)>;

/// Pings the process at the other end twice a second while the channel is open. Closes the channel
/// after 1.5 s without an answer, since a process that hangs or is cut off does not close it. Waits
/// longer while large messages are on their way or in hand, since they may delay the answer.
/// `worker` provides the timer.
void WatchOver(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel,
               const HearTime& hear_time = nullptr);

/// For the acceptor of a channel, which sends no requests of its own: calls Channel::Expire() every
/// second on `worker`, while the channel is open.
void KeepExpiring(Worker& worker, const std::weak_ptr<Channel>& channel);

}  // namespace tendon
