#include <gcm_console/verbs/verb.h>
#include <program/broker.h>
#include <program/lcm_launch_options.h>
#include <tendon/base/log.h>
#include <tendon/base/os/file.h>
#include <tendon/base/os/process.h>
#include <tendon/base/os/socket.h>
#include <tendon/base/os/termination.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/middleware.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>

namespace console {
namespace {

tendon::Error WithHint(tendon::Error error) {
  if (error.code == tendon::ErrorCode::kExists) {
    error.message += "; use the running GCM, or give another port with --gcm";
  }
  return error;
}

tendon::Result<program::ExitCode> Serve(Context& context, const std::string& broker) {
  if (!context.streams().has_input) {
    return tendon::Error{tendon::ErrorCode::kInvalid,
                         "serve runs until it is stopped: start gcm serve in a terminal"};
  }
  tendon::os::HoldTerminationSignals();
  const Settings& settings = context.settings();
  if (auto address = program::CheckGcmAddress(settings.gcm, settings.network); !address) {
    return address.error();
  }
  const auto exposure = settings.network.certificate.empty() ? tendon::Exposure::kLoopbackOnly
                                                             : tendon::Exposure::kCertified;
  if (const auto place = tendon::ParseAllowedAddress(broker, 1, exposure);
      !broker.empty() && !place) {
    return tendon::Error{place.error().code, "--broker: " + place.error().message};
  }
  if (auto own = program::CheckOwnPort("--broker", broker, settings.gcm); !own) {
    return own.error();
  }
  auto middleware = program::MakeMiddleware(settings.network);
  if (!middleware) return middleware.error();
  auto manager = tendon::GlobalManager::Start(
      *middleware, {.address = settings.gcm,
                    .state_folder = tendon::os::StateFolder(),
                    .launch = program::LcmLaunchOptions(settings.network),
                    .broker = broker});
  if (!manager) return WithHint(manager.error());
  if (tendon::os::RunsAsRoot()) {
    tendon::Log(tendon::LogLevel::kWarning, "gcm",
                "runs as root, but a GCM does not need the rights of root");
  }
  context.out() << "GCM at " << (*manager)->address() << std::endl;
  tendon::os::WaitForTermination();
  return program::kOk;
}

Verb::Run PrepareServe(CLI::App& app) {
  const auto broker = std::make_shared<std::string>();
  app.add_option("--broker", *broker,
                 "address of a running gcm broker, which distributes rows to many viewers")
      ->type_name("ADDRESS");
  return [broker](Context& context) { return Serve(context, *broker); };
}

/// The memory limit of the broker. A message may claim to have 2^31 facets; Ice would then try to
/// allocate 64 GiB. With the limit, this allocation fails, and Ice refuses the message and
/// continues.
constexpr std::size_t kMaxOfBroker = std::size_t{8} << 30U;

/// Writes a file that only this user can read, because the names of the broker's objects are
/// secret.
tendon::Result<std::filesystem::path> WriteSettings(const std::string& address,
                                                    const std::string& settings) {
  std::string name = "broker-" + address + ".conf";
  std::replace(name.begin(), name.end(), '/', '-');
  auto file = tendon::os::RuntimeFolder() / name;
  std::error_code ignored;
  std::filesystem::remove(file, ignored);
  const auto written = tendon::os::ReadOrMakePrivateFile(file, settings);
  if (!written) return written.error();
  return file;
}

tendon::Result<program::ExitCode> RunBroker(Context& context, const std::string& address) {
  if (context.session() != nullptr || !context.streams().has_input) {
    return tendon::Error{tendon::ErrorCode::kInvalid,
                         "broker runs until it is stopped: start gcm broker outside of gcm shell"};
  }
  if (const auto place = tendon::ParseAddress(address, 1)) {
    if (const auto may = tendon::os::ListenAt(place->host, place->port); !may) return may.error();
  }
  const auto settings = program::BrokerSettings(address, context.settings().network);
  if (!settings) return settings.error();
  const auto file = WriteSettings(address, *settings);
  if (!file) return file.error();
  tendon::os::BecomeProgram({"icebox", "--Ice.Config=" + file->string()}, kMaxOfBroker);
  return tendon::Error{tendon::ErrorCode::kNotFound,
                       "icebox is not installed; to install it: apt-get install zeroc-icebox "
                       "libzeroc-icestorm3.7 (tools/setup does this, too)"};
}

Verb::Run PrepareBroker(CLI::App& app) {
  const auto address = std::make_shared<std::string>(program::kBrokerAddress);
  app.add_option("--listen", *address,
                 "address at which the broker listens for processes and viewers")
      ->type_name("ADDRESS")
      ->capture_default_str();
  return [address](Context& context) { return RunBroker(context, *address); };
}

}  // namespace

std::vector<Verb> ServeVerbs() {
  return {
      {"serve", "run a GCM at the address of --gcm until it is stopped", &PrepareServe},
      {"broker",
       "run IceStorm, which distributes rows to many viewers",
       &PrepareBroker,
       {"gcm broker", "gcm serve --broker 127.0.0.1:10706"}},
  };
}

}  // namespace console
