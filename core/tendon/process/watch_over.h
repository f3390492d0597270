#pragma once

#include <tendon/base/clock.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <memory>

namespace tendon {

/// After so long without a word the program at the other end is taken for one that hangs.
inline constexpr std::chrono::milliseconds kLongestPeerSilence(1500);

/// Whether a word may yet come that waits behind a large message, at either end.
[[nodiscard]] bool MayBeHeldUp(const Channel& channel, SteadyTime now,
                               std::chrono::milliseconds silence);

/// Hears when a question was sent and its answer arrived, by our clock, and what the other process'
/// steady clock showed in between. In a thread of the middleware.
using HearTime = std::function<void(SteadyTime sent, SteadyTime there, SteadyTime arrived)>;

/// Asks the process at the other end twice a second whether it lives, as long as the channel is
/// open, and closes the channel when there was no answer for 1.5 s: a process that hangs, or has
/// been cut off, does not close it. Large messages that are on their way, or in hand, may hold the
/// answer up: as long as they go on there is no hurry. `worker` sees to the time.
void WatchOver(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel,
               const HearTime& hear_time = nullptr);

/// For who has accepted a channel and asks nothing on it: each second, on `worker`, what must end
/// in time does (Channel::Expire()), as long as the channel is open.
void KeepExpiring(Worker& worker, const std::weak_ptr<Channel>& channel);

}  // namespace tendon
