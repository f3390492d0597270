#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>

namespace tendon {

/// Calls Channel::Request() with a timeout. The error is explained for this request, see
/// ExplainFailure(). `timer` calls Channel::Expire(), which ends the request. If `timer` ends, the
/// request no longer times out.
template <Payload ReplyBody, Message T>
void Ask(Worker& timer, const std::shared_ptr<Channel>& channel, MessageType type, const T& value,
         std::chrono::milliseconds timeout, std::function<void(Result<ReplyBody>)> handler,
         Lane lane = kCommonLane) {
  channel->Request<ReplyBody>(
      type, 0, value, timeout,
      [handler = std::move(handler), type, peer = channel->peer().name](Result<ReplyBody> reply) {
        if (reply) return handler(std::move(reply));
        handler(ExplainFailure(reply.error(), type, peer));
      },
      lane);
  timer.PostAfter(timeout + std::chrono::milliseconds(1), [peer = std::weak_ptr(channel)] {
    if (const auto still_there = peer.lock()) still_there->Expire(SteadyClock().Now());
  });
}

/// Sends a notice without a body. While the link is full, `worker` repeats the attempt.
inline void NotifyUntilSent(const std::weak_ptr<Worker>& worker,
                            const std::shared_ptr<Channel>& channel, MessageType type,
                            std::uint32_t handle, Lane lane = kCommonLane) {
  constexpr std::chrono::milliseconds kUntilLinkHasRoom(20);
  if (channel->Notify(type, handle, Bytes(), lane) != Status(Status::kQueueFull)) return;
  const auto still_at_work = worker.lock();
  if (!still_at_work) return;
  still_at_work->PostAfter(kUntilLinkHasRoom, [worker, channel, type, handle, lane] {
    NotifyUntilSent(worker, channel, type, handle, lane);
  });
}

}  // namespace tendon
