#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/membership/differences.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace tendon {

class LoopbackNetwork;

/// The access of a component, such as a recorder, to all components of its own process: the same
/// services that viewers use, but without a socket. Valid also after the process has ended; then
/// nothing answers. Made by Process::OpenLocalAccess().
///
/// Thread safety: all functions, from any thread. None of them waits.
class LocalAccess {
 public:
  /// The only address on its middlewares.
  static constexpr const char* kAddress = "127.0.0.1:1";

  /// Fills in the components and connections of the process. Returns false if that is not possible
  /// now, because the manager is busy with a request.
  using Describe = std::function<bool(ProcessContent&)>;

  LocalAccess(std::string process, std::uint64_t instance, Describe describe);

  /// The name of the process.
  [[nodiscard]] const std::string& process() const { return process_; }
  [[nodiscard]] std::uint64_t instance() const { return instance_; }

  /// A middleware that reaches only this process, at kAddress. It has a thread of its own.
  [[nodiscard]] std::shared_ptr<Middleware> MakeMiddleware() const;
  /// Also false after Close().
  [[nodiscard]] bool TryDescribe(ProcessContent& content) const;

  // For the process.

  /// Lets others open links to the process.
  Result<void> Listen(AcceptLink accept);
  /// Ends all links. Call it before the process loses what its links and `describe` use.
  void Close();

 private:
  const std::string process_;
  const std::uint64_t instance_;
  const std::shared_ptr<LoopbackNetwork> network_;
  mutable std::mutex mutex_;  // guards the members below
  Describe describe_;
  std::shared_ptr<Middleware> middleware_;
  std::unique_ptr<Listener> listener_;
};

}  // namespace tendon
