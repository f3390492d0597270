#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <memory>
#include <utility>

namespace tendon {

/// Channel::Request() with a timeout that works as long as `timer` lives, which calls Expire().
template <Payload Answer, Message T>
void Ask(Worker& timer, const std::shared_ptr<Channel>& channel, MessageType type, const T& value,
         std::chrono::milliseconds timeout, std::function<void(Result<Answer>)> handler,
         Lane lane = kCommonLane) {
  channel->Request<Answer>(type, 0, value, timeout, std::move(handler), lane);
  timer.PostAfter(timeout + std::chrono::milliseconds(1), [peer = std::weak_ptr(channel)] {
    if (const auto still_there = peer.lock()) still_there->Expire(SteadyClock().Now());
  });
}

}  // namespace tendon
