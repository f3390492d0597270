#include <gcm_console/verb.h>
#include <program/lcm_launch.h>
#include <tendon/base/log.h>
#include <tendon/base/os/process.h>
#include <tendon/base/os/termination.h>
#include <tendon/gcm/global_manager.h>

#include <CLI/CLI.hpp>
#include <ostream>

namespace console {
namespace {

tendon::Error WithHint(tendon::Error error) {
  if (error.code == tendon::ErrorCode::kExists) {
    error.message += "; use the GCM that is there, or give --gcm another port";
  }
  return error;
}

tendon::Result<program::ExitCode> Serve(Context& context) {
  tendon::os::HoldTerminationSignals();
  const Settings& settings = context.settings();
  if (auto address = program::CheckGcmAddress(settings.gcm, settings.network); !address) {
    return address.error();
  }
  auto middleware = program::MakeMiddleware(settings.network);
  if (!middleware) return middleware.error();
  auto manager =
      tendon::GlobalManager::Start(*middleware, {.address = settings.gcm,
                                                 .state_folder = tendon::os::StateFolder(),
                                                 .launch = program::LcmLaunch(settings.network)});
  if (!manager) return WithHint(manager.error());
  if (tendon::os::RunsAsRoot()) {
    tendon::Log(tendon::LogLevel::kWarning, "gcm", "runs as root, which a GCM does not need");
  }
  context.out() << "GCM at " << (*manager)->address() << std::endl;
  tendon::os::WaitForTermination();
  return program::kOk;
}

}  // namespace

std::vector<Verb> ServeVerbs() {
  return {{"serve", "run a GCM at the address of --gcm until told to stop",
           [](CLI::App&) -> Verb::Run { return &Serve; }}};
}

}  // namespace console
