#include <lcm/lcm_program.h>
#include <program/middleware_choice.h>
#include <tendon/base/log.h>
#include <tendon/base/os/termination.h>
#include <tendon/manager/component_loader.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <vector>

namespace lcm {
namespace {

using program::ExitCode;
using tendon::Error;
using tendon::Result;
using namespace std::chrono_literals;

constexpr auto kJoinTimeout = 3s;

/// What the system file says about one process.
struct Share {
  std::vector<tendon::SystemFile::Component> components;
  std::vector<tendon::SystemFile::Connection> connections;  ///< those it owns
};

Result<Share> ReadShare(const Options& options) {
  Share share;
  if (options.system.empty()) return share;
  const auto system = tendon::ReadSystemFile(options.system);
  if (!system) return system.error();
  const auto* process = system->FindProcess(options.name);
  if (process == nullptr) {
    std::vector<std::string> names;
    for (const auto& known : system->processes) names.push_back(known.name);
    return Error{tendon::ErrorCode::kNotFound, options.system + " has no process '" + options.name +
                                                   "'" + tendon::DidYouMean(options.name, names)};
  }
  share.components = process->components;
  for (const auto& connection : system->connections) {
    if (connection.required.process == options.name) share.connections.push_back(connection);
  }
  return share;
}

/// A component that waits for its process.
struct Made {
  std::unique_ptr<tendon::Component> component;
  tendon::ComponentOrigin origin;
};

Result<std::vector<Made>> MakeComponents(const Share& share, tendon::ComponentLoader& loader) {
  std::vector<Made> all;
  for (const auto& one : share.components) {
    auto component = loader.Create(one.library, one.class_name, one.name, one.configuration);
    if (!component) return component.error();
    all.push_back({std::move(*component), {.class_name = one.class_name, .library = one.library}});
  }
  return all;
}

/// A connection that cannot be made now is not the end: its peer may still come. One that never
/// can be is told and leaves the others alone.
void MakeConnections(const Share& share, tendon::Process& process) {
  for (const auto& one : share.connections) {
    if (auto made = process.Connect(one.required, one.provided); !made) {
      tendon::Log(tendon::LogLevel::kError, process.name(),
                  "not connected: " + made.error().message);
    }
  }
}

Result<void> Serve(const Options& options) {
  auto share = ReadShare(options);
  if (!share) return share.error();
  const auto exposure =
      options.insecure ? tendon::Exposure::kInsecure : tendon::Exposure::kLoopbackOnly;
  auto middleware = program::MakeMiddleware(options.middleware, exposure);
  if (!middleware) return middleware.error();

  if (auto checked = tendon::CheckName("process", options.name); !checked) return checked;
  tendon::ComponentLoader loader;
  auto components = MakeComponents(*share, loader);  // before anybody hears of this process
  if (!components) return components.error();
  tendon::Process process(options.name, {.middleware = *middleware,
                                         .gcm = options.gcm,
                                         .listen = options.listen,
                                         .advertise = options.advertise});
  for (Made& one : *components) process.Add(std::move(one.component), std::move(one.origin));
  if (auto joined = process.WaitUntilJoined(kJoinTimeout); !joined) return joined;
  MakeConnections(*share, process);
  if (auto started = process.StartAll(); !started) {
    tendon::Log(tendon::LogLevel::kError, options.name, started.error().message);
  }
  tendon::Log(tendon::LogLevel::kInfo, options.name,
              "runs " + std::to_string(share->components.size()) +
                  " components, joined the GCM at " + options.gcm);
  tendon::os::WaitForTermination();
  return {};
}

}  // namespace

ExitCode Run(const Options& options) {
  try {
    const auto served = Serve(options);
    if (served) return program::kOk;
    std::fprintf(stderr, "lcm: %s\n", served.error().message.c_str());
    return program::ExitCodeOf(served.error().code);
  } catch (const tendon::ConfigurationError& error) {
    std::fprintf(stderr, "lcm: %s\n", error.what());
    return program::kUsage;
  } catch (const std::exception& error) {  // no memory, no files left
    std::fprintf(stderr, "lcm: %s\n", error.what());
    return program::kRefused;
  }
}

}  // namespace lcm
