#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <memory>
#include <utility>

namespace tendon {

/// Channel::Request() whose timeout `timer` enforces by calling Expire(). Only while the timer
/// lives.
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
