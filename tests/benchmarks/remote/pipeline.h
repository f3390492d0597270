#pragma once

#include <benchmarks/remote/remote_system.h>
#include <tendon/middleware/channel.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace tendon::benchmark {

/// Begins a call. The call ends later, in any thread, by `done(ok)`.
using BeginCall = std::function<void(std::function<void(bool ok)> done)>;

/// Makes `calls` calls, at most `window` of them at a time: when one call ends, the next one
/// begins. Returns when all calls have ended.
void RunPipeline(std::uint64_t calls, std::uint64_t window, const BeginCall& begin);

/// Calls the robot's command Move like a connection that waits for the execution, but with many
/// calls at a time.
class WaitingCalls {
 public:
  WaitingCalls(RemoteSystem& system, std::uint64_t window);
  WaitingCalls(const WaitingCalls&) = delete;
  WaitingCalls& operator=(const WaitingCalls&) = delete;
  ~WaitingCalls();

  /// Makes `calls` calls; see RunPipeline().
  void Run(std::uint64_t calls);

 private:
  const std::uint64_t window_;
  const std::shared_ptr<Middleware> middleware_;
  std::shared_ptr<Channel> channel_;
  std::uint32_t handle_ = 0;
  Bytes question_;
};

}  // namespace tendon::benchmark
