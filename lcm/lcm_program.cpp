#include <lcm/lcm_program.h>

#include <tendon/base/log.h>
#include <tendon/base/os/process.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/gcm/system/leaders.h>
#include <tendon/manager/component_loader.h>
#include <tendon/manager/unsatisfied_interface.h>
#include <tendon/process/membership/advertised_address.h>
#include <tendon/task/threaded_task.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace lcm {
namespace {

using program::ExitCode;
using tendon::ComponentState;
using tendon::Error;
using tendon::ErrorCode;
using tendon::InterfaceName;
using tendon::Result;
using namespace std::chrono_literals;

/// The part of a system file that describes one process.
struct ProcessPart {
  std::vector<tendon::SystemFile::Component> components;
  /// The connections that the process owns.
  std::vector<tendon::SystemFile::Connection> connections;
  bool is_strict = false;
};

Result<ProcessPart> ReadPart(const Options& options) {
  ProcessPart part;
  if (options.system.empty()) return part;
  const auto system = tendon::ReadSystemFile(options.system);
  if (!system) return system.error();
  const auto* process = system->FindProcess(options.name);
  if (process == nullptr) {
    std::vector<std::string> names;
    for (const auto& known : system->processes) names.push_back(known.name);
    return Error{ErrorCode::kNotFound, options.system + " has no process '" + options.name + "'" +
                                           tendon::DidYouMean(options.name, names)};
  }
  part.components = process->components;
  part.is_strict = system->strict;
  PutLeadersFirst(part.components);
  for (const auto& connection : system->connections) {
    if (connection.required.process == options.name) part.connections.push_back(connection);
  }
  return part;
}

/// A created component that is not yet added to the process.
struct CreatedComponent {
  std::unique_ptr<tendon::Component> component;
  tendon::ComponentOrigin origin;
};

Result<void> SetThread(const tendon::SystemFile::Component& wanted, tendon::Component& component) {
  if (!wanted.thread) return {};
  auto* const task = dynamic_cast<tendon::ThreadedTask*>(&component);
  if (task == nullptr) {
    return Error{ErrorCode::kInvalid, "component '" + wanted.name + "' (class " +
                                          wanted.class_name +
                                          ") has no thread of its own: leave out its \"thread\""};
  }
  task->SetThreadOptions(*wanted.thread);
  return {};
}

Error NoLibrary(const tendon::SystemFile::Component& wanted,
                const tendon::ComponentLoader& loader) {
  return {ErrorCode::kInvalid,
          "component '" + wanted.name +
              "' has no \"library\" in the file: add the name of the plug-in that has class " +
              wanted.class_name + "; available: " + tendon::Joined(loader.available(), ", ")};
}

Result<std::vector<CreatedComponent>> MakeComponents(const ProcessPart& part,
                                                     tendon::ComponentLoader& loader) {
  std::vector<CreatedComponent> all;
  for (const auto& one : part.components) {
    if (one.class_name.empty()) {
      return Error{ErrorCode::kInvalid, "component '" + one.name +
                                            "' has no class in the file, because another program "
                                            "creates it: start that program instead of lcm"};
    }
    if (one.library.empty()) return NoLibrary(one, loader);
    auto component = loader.Create(one.library, one.class_name, one.name, one.configuration);
    if (!component) return component.error();
    if (const auto set = SetThread(one, **component); !set) return set.error();
    all.push_back({std::move(*component),
                   {.class_name = one.class_name,
                    .library = one.library,
                    .configuration = one.configuration}});
  }
  return all;
}

/// Creates the process, which listens and begins to join.
Result<std::unique_ptr<tendon::Process>> MakeProcess(
    const Options& options, const std::shared_ptr<tendon::Middleware>& middleware,
    const std::shared_ptr<tendon::ComponentLoader>& loader) {
  if (!options.advertise.empty()) {
    if (auto good = tendon::CheckAdvertise(options.advertise); !good) return good.error();
  }
  if (auto own = program::CheckOwnPort("--listen", options.listen, options.gcm); !own) {
    return own.error();
  }
  try {
    return std::make_unique<tendon::Process>(options.name,
                                             tendon::ProcessOptions{.middleware = middleware,
                                                                    .gcm = options.gcm,
                                                                    .listen = options.listen,
                                                                    .advertise = options.advertise,
                                                                    .loader = loader,
                                                                    .history = options.history});
  } catch (const tendon::ConfigurationError& error) {
    const bool is_taken = error.code() == ErrorCode::kExists;
    const std::string hint =
        is_taken ? "; give another port with --listen, or 0 for a free port" : "";
    return Error{error.code(), error.what() + hint};
  }
}

/// Adds the components. A component that has a leader runs after it.
Result<void> AddComponents(const ProcessPart& part, std::vector<CreatedComponent> made,
                           tendon::Process& process) {
  for (CreatedComponent& one : made) process.Add(std::move(one.component), std::move(one.origin));
  for (const auto& one : part.components) {
    if (one.runs_after.empty()) continue;
    if (auto follows = process.RunAfter(one.name, one.runs_after); !follows) return follows;
  }
  return {};
}

enum class StartResult { kGoOn, kEnd };

/// Waits until the process has joined, cannot join, or is asked to terminate.
Result<StartResult> Join(const tendon::Process& process, const Options& options) {
  constexpr auto kLook = 10ms;
  const auto deadline = std::chrono::steady_clock::now() + options.timeout;
  while (!tendon::os::TerminationRequested(kLook)) {
    const auto joined = process.WaitUntilJoined(0ms);
    if (joined) return StartResult::kGoOn;
    const ErrorCode code = joined.error().code;
    const bool may_come = code == ErrorCode::kUnreachable || code == ErrorCode::kTimeout;
    if (!may_come) return joined.error();
    if (std::chrono::steady_clock::now() < deadline) continue;
    if (code == ErrorCode::kUnreachable) return joined.error();
    return Error{ErrorCode::kUnreachable, "the GCM at " + options.gcm + " does not answer"};
  }
  return StartResult::kEnd;
}

/// Returns the provided interface to which the required interface is connected now; empty if there
/// is none.
std::optional<InterfaceName> ProviderOf(const tendon::Process& process,
                                        const InterfaceName& required) {
  for (const auto& connection : process.connections()) {
    if (connection.required == required) return connection.provided;
  }
  return std::nullopt;
}

/// Makes all connections. If a peer is absent, its connection is pending, because the peer may
/// appear later. If a connection can never be made, logs an error and continues with the other
/// connections. Keeps a connection that the GCM has restored meanwhile.
void MakeConnections(const ProcessPart& part, tendon::Process& process) {
  for (const auto& one : part.connections) {
    const auto made = process.Connect(one.required, one.provided);
    if (made) continue;
    const auto provider = ProviderOf(process, one.required);
    if (provider == one.provided) continue;
    tendon::Log(tendon::LogLevel::kError, process.name(),
                "not connected to " + ToString(one.provided) + ": " +
                    (provider ? ToString(one.required) + " was connected to " +
                                    ToString(*provider) + " before, and this connection stays"
                              : made.error().message));
  }
}

/// True if another component runs after this one. Such followers cannot start while their leader is
/// suspended.
bool Leads(const ProcessPart& part, const tendon::SystemFile::Component& component) {
  return std::ranges::any_of(part.components,
                             [&](const auto& one) { return one.runs_after == component.name; });
}

/// Waits until the needed interfaces of a component in a strict file are connected, at most for the
/// time limit in `options`. Fails if there is no connection for a needed interface.
Result<StartResult> AwaitNeeds(const tendon::Process& process, const std::string& component,
                               const Options& options) {
  constexpr auto kLook = 10ms;
  const auto deadline = std::chrono::steady_clock::now() + options.timeout;
  while (true) {
    const auto all = process.components();
    const auto* description = tendon::FindNamed(all, component);
    const auto needs = description == nullptr ? std::vector<tendon::UnsatisfiedInterface>()
                                              : UnmetNeedsOf(*description, process.connections());
    const bool may_come =
        !needs.empty() && std::ranges::all_of(needs, &tendon::UnsatisfiedInterface::has_connection);
    const bool is_over = !may_come || std::chrono::steady_clock::now() >= deadline;
    if (is_over) {
      const auto met = CheckNeeds(component, needs);
      return met ? Result<StartResult>(StartResult::kGoOn) : met.error();
    }
    if (tendon::os::TerminationRequested(kLook)) return StartResult::kEnd;
  }
}

Result<StartResult> TransitionToState(const ProcessPart& part, tendon::Process& process,
                                      const std::string& component, ComponentState state,
                                      const Options& options) {
  if (part.is_strict && IsRunning(state)) {
    const auto result = AwaitNeeds(process, component, options);
    if (!result || *result == StartResult::kEnd) return result;
  }
  const auto begun = process.TransitionTo(component, state);
  return begun ? Result<StartResult>(StartResult::kGoOn) : begun.error();
}

/// Makes the connections and starts the components. If one component fails, the others are started
/// anyway.
StartResult Start(const ProcessPart& part, tendon::Process& process, const Options& options) {
  MakeConnections(part, process);
  std::vector<std::string> to_suspend;
  for (const auto& one : part.components) {
    if (tendon::os::TerminationRequested(std::chrono::milliseconds(0))) return StartResult::kEnd;
    const bool is_suspended_later = one.state == ComponentState::kSuspended && Leads(part, one);
    const auto state = is_suspended_later ? ComponentState::kActive : one.state;
    const auto begun = TransitionToState(part, process, one.name, state, options);
    if (begun && *begun == StartResult::kEnd) return StartResult::kEnd;
    if (!begun) tendon::Log(tendon::LogLevel::kError, options.name, begun.error().message);
    if (is_suspended_later) to_suspend.push_back(one.name);
  }
  for (const std::string& name : to_suspend) {
    if (const auto suspended = process.Suspend(name); !suspended) {
      tendon::Log(tendon::LogLevel::kError, options.name, suspended.error().message);
    }
  }
  if (tendon::os::RunsAsRoot()) {
    tendon::Log(tendon::LogLevel::kWarning, options.name,
                "runs as root, so each plug-in also has the rights of root; start lcm as another "
                "user, with the limits rtprio and memlock");
  }
  tendon::Log(tendon::LogLevel::kInfo, options.name,
              "runs " + tendon::Counted(part.components.size(), "component", "components") +
                  ", joined the GCM at " + options.gcm);
  return StartResult::kGoOn;
}

Result<void> Serve(const Options& options) {
  if (auto checked = tendon::CheckName("process", options.name); !checked) return checked;
  auto part = ReadPart(options);
  if (!part) return part.error();
  auto middleware = program::MakeMiddleware(options.network);
  if (!middleware) return middleware.error();
  const auto loader = std::make_shared<tendon::ComponentLoader>();
  auto components = MakeComponents(*part, *loader);  // before other programs can see this process
  if (!components) return components.error();
  // Logs only warnings and errors until the process has joined. If the process cannot join, the
  // final error gives the reason.
  tendon::SetLogLevel(tendon::LogLevel::kWarning);
  auto process = MakeProcess(options, *middleware, loader);
  if (!process) return process.error();
  if (auto added = AddComponents(*part, *std::move(components), **process); !added) return added;
  const auto joined = Join(**process, options);
  if (!joined) return joined.error();
  if (*joined == StartResult::kEnd) return {};
  tendon::SetLogLevel(tendon::LogLevel::kInfo);
  if (Start(*part, **process, options) == StartResult::kGoOn) tendon::os::WaitForTermination();
  return {};
}

ExitCode Refuse(ErrorCode code, const std::string& sentence) {
  std::fprintf(stderr, "lcm: %s\n", tendon::Printable(sentence).c_str());
  return program::ExitCodeOf(code);
}

}  // namespace

ExitCode Run(const Options& options) {
  try {
    const auto served = Serve(options);
    return served ? program::kOk : Refuse(served.error().code, served.error().message);
  } catch (const tendon::ConfigurationError& error) {
    return Refuse(error.code(), error.what());
  } catch (const std::exception& error) {  // out of memory or files
    return Refuse(ErrorCode::kFailed, error.what());
  }
}

}  // namespace lcm
