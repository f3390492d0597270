#include <gcm_gui/session/hosted_gcm.h>

#include <tendon/base/log.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/process/process.h>

#include <utility>

namespace tendon::gui {

Result<std::unique_ptr<HostedGcm>> HostedGcm::Start(const std::shared_ptr<Middleware>& middleware,
                                                    const std::string& address,
                                                    LaunchOptions launch) {
  auto manager =
      GlobalManager::Start(middleware, {.address = address, .launch = std::move(launch)});
  if (!manager) return manager.error();
  std::unique_ptr<HostedGcm> hosted(new HostedGcm(std::move(*manager)));
  try {
    hosted->process_ = std::make_unique<Process>(
        "gcm", ProcessOptions{.middleware = middleware, .gcm = hosted->address()});
  } catch (const ConfigurationError& error) {
    // The GCM continues without its own process, because it serves other processes.
    Log(LogLevel::kWarning, "gcm-gui", error.what());
  }
  return hosted;
}

HostedGcm::HostedGcm(std::unique_ptr<GlobalManager> manager) : manager_(std::move(manager)) {}

HostedGcm::~HostedGcm() {
  process_.reset();  // before the GCM, so that the process can leave it
}

std::string HostedGcm::address() const { return manager_->address(); }

}  // namespace tendon::gui
