#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstdint>
#include <memory>

namespace tendon {

/// Whether the viewer at the other end of one channel lives. It asks twice a second whether we do;
/// where it has once asked and then was silent for 1.5 s, the channel is closed, and with it end
/// its subscriptions: a viewer that hangs does not close it, and would be sent rows for ever. One
/// that was only slow opens the channel again and knows what it has missed.
class ViewerWatch final : public std::enable_shared_from_this<ViewerWatch> {
 public:
  explicit ViewerWatch(std::weak_ptr<Worker> worker) : worker_(std::move(worker)) {}

  /// It has asked. Any thread; wait-free.
  void Hear() noexcept { heard_.Set(SteadyClock().Now()); }
  /// From now on, on the worker, as long as the channel is open. Again does nothing; one thread.
  void Begin(const std::shared_ptr<Channel>& channel);

 private:
  void LookAfter(std::chrono::milliseconds delay);
  void Look(SteadyTime due);

  const std::weak_ptr<Worker> worker_;
  std::weak_ptr<Channel> channel_;  // of the worker, once it has begun
  bool has_begun_ = false;
  Published<SteadyTime> heard_;
};

}  // namespace tendon
