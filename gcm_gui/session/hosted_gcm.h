#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/supervisor/launch_options.h>
#include <tendon/middleware/middleware.h>

#include <memory>
#include <string>

namespace tendon {
class GlobalManager;
class Process;
}  // namespace tendon

namespace tendon::gui {

/// A GCM inside this program. Its first member is the process of this program, "gcm".
class HostedGcm {
 public:
  /// Starts the GCM; `launch` starts processes for it. Errors: kExists if there is already a GCM at
  /// this address, and the errors of Middleware::Listen().
  static Result<std::unique_ptr<HostedGcm>> Start(const std::shared_ptr<Middleware>& middleware,
                                                  const std::string& address,
                                                  LaunchOptions launch = {});
  HostedGcm(const HostedGcm&) = delete;
  HostedGcm& operator=(const HostedGcm&) = delete;
  ~HostedGcm();

  /// Returns the address that the GCM announces.
  [[nodiscard]] std::string address() const;

 private:
  explicit HostedGcm(std::unique_ptr<GlobalManager> manager);

  std::unique_ptr<GlobalManager> manager_;
  std::unique_ptr<Process> process_;
};

}  // namespace tendon::gui
