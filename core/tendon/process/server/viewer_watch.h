#pragma once

#include <tendon/base/clock.h>
#include <tendon/lockfree/flag.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <cstdint>
#include <memory>

namespace tendon {

/// Closes the channel of a viewer that hangs. A viewer pings twice a second; after its first ping,
/// a silence of 1.5 s closes the channel and ends its subscriptions. Otherwise the process would
/// send rows to a hanging viewer for ever. A viewer that was only slow opens the channel again and
/// counts the rows that it missed.
class ViewerWatch final : public std::enable_shared_from_this<ViewerWatch> {
 public:
  explicit ViewerWatch(std::weak_ptr<Worker> worker) : worker_(std::move(worker)) {}

  /// Notes a ping. Any thread; wait-free.
  void Hear() noexcept { heard_.Set(SteadyClock().Now()); }
  /// Starts checking on the worker while the channel is open. Further calls do nothing. Called by
  /// one thread.
  void Begin(const std::shared_ptr<Channel>& channel);

 private:
  void LookAfter(std::chrono::milliseconds delay);
  void Look(SteadyTime due);

  const std::weak_ptr<Worker> worker_;
  std::weak_ptr<Channel> channel_;  // used only on the worker after Begin()
  bool has_begun_ = false;
  Published<SteadyTime> heard_;
};

}  // namespace tendon
