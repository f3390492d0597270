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

/// Gives a component, such as a recorder, access to all components of its own process. The
/// component uses the same services as a viewer, but without a socket. This object stays valid when
/// the process has ended; then requests get no reply. Made by Process::OpenLocalAccess().
///
/// Thread safety: any thread may call all functions. They do not wait.
class LocalAccess {
 public:
  /// The only address that its middlewares can reach.
  static constexpr const char* kAddress = "127.0.0.1:1";

  /// Fills in the components and connections of the process. Returns false if the manager is busy
  /// with a request, so that this is not possible now.
  using Describe = std::function<bool(ProcessContent&)>;

  LocalAccess(std::string process, std::uint64_t instance, Describe describe);

  /// The name of the process.
  [[nodiscard]] const std::string& process() const { return process_; }
  [[nodiscard]] std::uint64_t instance() const { return instance_; }

  /// Makes a middleware that reaches only this process, at kAddress. It has its own thread.
  [[nodiscard]] std::shared_ptr<Middleware> MakeMiddleware() const;
  /// Returns false if the description is not possible now, or after Close().
  [[nodiscard]] bool TryDescribe(ProcessContent& content) const;

  // For the process.

  /// Begins to accept links to the process.
  Result<void> Listen(AcceptLink accept);
  /// Ends all links. Call it before the process destroys the parts that the links and `describe`
  /// use.
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
