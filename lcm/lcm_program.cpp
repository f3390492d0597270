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

/// The part of a system file about one process.
struct Share {
  std::vector<tendon::SystemFile::Component> components;
  std::vector<tendon::SystemFile::Connection> connections;  ///< that it owns
  bool is_strict = false;
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
    return Error{ErrorCode::kNotFound, options.system + " has no process '" + options.name + "'" +
                                           tendon::DidYouMean(options.name, names)};
  }
  share.components = process->components;
  share.is_strict = system->strict;
  PutLeadersFirst(share.components);
  for (const auto& connection : system->connections) {
    if (connection.required.process == options.name) share.connections.push_back(connection);
  }
  return share;
}

/// A created component that is not yet added to the process.
struct Made {
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
  std::string all;
  for (const std::string& known : loader.available()) all += (all.empty() ? "" : ", ") + known;
  return {ErrorCode::kInvalid, "component '" + wanted.name +
                                   "' has no \"library\" in the file: name the plug-in there that "
                                   "has its class " +
                                   wanted.class_name + "; there is: " + all};
}

Result<std::vector<Made>> MakeComponents(const Share& share, tendon::ComponentLoader& loader) {
  std::vector<Made> all;
  for (const auto& one : share.components) {
    if (one.class_name.empty()) {
      return Error{ErrorCode::kInvalid, "component '" + one.name +
                                            "' has no class in the file, because its own program "
                                            "creates it: start that program, not lcm"};
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
                                                                    .loader = loader});
  } catch (const tendon::ConfigurationError& error) {
    const bool is_taken = error.code() == ErrorCode::kExists;
    const std::string hint = is_taken ? "; give --listen another port, or 0 for a free one" : "";
    return Error{error.code(), error.what() + hint};
  }
}

/// Adds the components, each with its leader, if any.
Result<void> AddComponents(const Share& share, std::vector<Made> made, tendon::Process& process) {
  for (Made& one : made) process.Add(std::move(one.component), std::move(one.origin));
  for (const auto& one : share.components) {
    if (one.runs_after.empty()) continue;
    if (auto follows = process.RunAfter(one.name, one.runs_after); !follows) return follows;
  }
  return {};
}

enum class Told { kGoOn, kEnd };

/// Waits until the process has joined, cannot join, or is asked to terminate.
Result<Told> Join(const tendon::Process& process, const Options& options) {
  constexpr auto kLook = 10ms;
  const auto deadline = std::chrono::steady_clock::now() + options.timeout;
  while (!tendon::os::TerminationRequested(kLook)) {
    const auto joined = process.WaitUntilJoined(0ms);
    if (joined) return Told::kGoOn;
    const ErrorCode code = joined.error().code;
    const bool may_come = code == ErrorCode::kUnreachable || code == ErrorCode::kTimeout;
    if (!may_come) return joined.error();
    if (std::chrono::steady_clock::now() < deadline) continue;
    if (code == ErrorCode::kUnreachable) return joined.error();
    return Error{ErrorCode::kUnreachable, "the GCM at " + options.gcm + " does not answer"};
  }
  return Told::kEnd;
}

/// The provided interface to which the required one is connected now, if any.
std::optional<InterfaceName> ProviderOf(const tendon::Process& process,
                                        const InterfaceName& required) {
  for (const auto& connection : process.connections()) {
    if (connection.required == required) return connection.provided;
  }
  return std::nullopt;
}

/// Continues after a failed connection, because its peer may appear later. Reports a connection
/// that can never be made, and continues with the others. Keeps a connection that the GCM has
/// restored meanwhile.
void MakeConnections(const Share& share, tendon::Process& process) {
  for (const auto& one : share.connections) {
    const auto made = process.Connect(one.required, one.provided);
    if (made) continue;
    const auto provider = ProviderOf(process, one.required);
    if (provider == one.provided) continue;
    tendon::Log(tendon::LogLevel::kError, process.name(),
                "not connected to " + ToString(one.provided) + ": " +
                    (provider ? ToString(one.required) + " was connected to " +
                                    ToString(*provider) + " before, and stays connected to it"
                              : made.error().message));
  }
}

/// True if another component runs after it. Such followers cannot start while their leader is
/// suspended.
bool Leads(const Share& share, const tendon::SystemFile::Component& component) {
  return std::ranges::any_of(share.components,
                             [&](const auto& one) { return one.runs_after == component.name; });
}

/// Waits until the needed interfaces of a component in a strict file are connected, at most for the
/// time limit in `options`. Fails if there is no connection for a needed interface.
Result<Told> AwaitNeeds(const tendon::Process& process, const std::string& component,
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
      return met ? Result<Told>(Told::kGoOn) : met.error();
    }
    if (tendon::os::TerminationRequested(kLook)) return Told::kEnd;
  }
}

Result<Told> BringToState(const Share& share, tendon::Process& process,
                          const std::string& component, ComponentState state,
                          const Options& options) {
  if (share.is_strict && IsRunning(state)) {
    const auto told = AwaitNeeds(process, component, options);
    if (!told || *told == Told::kEnd) return told;
  }
  const auto begun = process.TransitionTo(component, state);
  return begun ? Result<Told>(Told::kGoOn) : begun.error();
}

/// An error of one component does not stop the others.
Told Start(const Share& share, tendon::Process& process, const Options& options) {
  MakeConnections(share, process);
  std::vector<std::string> resting;
  for (const auto& one : share.components) {
    if (tendon::os::TerminationRequested(std::chrono::milliseconds(0))) return Told::kEnd;
    const bool rests_later = one.state == ComponentState::kSuspended && Leads(share, one);
    const auto state = rests_later ? ComponentState::kActive : one.state;
    const auto begun = BringToState(share, process, one.name, state, options);
    if (begun && *begun == Told::kEnd) return Told::kEnd;
    if (!begun) tendon::Log(tendon::LogLevel::kError, options.name, begun.error().message);
    if (rests_later) resting.push_back(one.name);
  }
  for (const std::string& name : resting) {
    if (const auto rests = process.Suspend(name); !rests) {
      tendon::Log(tendon::LogLevel::kError, options.name, rests.error().message);
    }
  }
  if (tendon::os::RunsAsRoot()) {
    tendon::Log(
        tendon::LogLevel::kWarning, options.name,
        "runs as root, and so does every plug-in; start it as a user with the limits rtprio "
        "and memlock instead");
  }
  tendon::Log(tendon::LogLevel::kInfo, options.name,
              "runs " + tendon::Counted(share.components.size(), "component", "components") +
                  ", joined the GCM at " + options.gcm);
  return Told::kGoOn;
}

Result<void> Serve(const Options& options) {
  if (auto checked = tendon::CheckName("process", options.name); !checked) return checked;
  auto share = ReadShare(options);
  if (!share) return share.error();
  auto middleware = program::MakeMiddleware(options.network);
  if (!middleware) return middleware.error();
  const auto loader = std::make_shared<tendon::ComponentLoader>();
  auto components = MakeComponents(*share, *loader);  // before others can see this process
  if (!components) return components.error();
  tendon::SetLogLevel(tendon::LogLevel::kWarning);  // the final error says why it has not joined
  auto process = MakeProcess(options, *middleware, loader);
  if (!process) return process.error();
  if (auto added = AddComponents(*share, *std::move(components), **process); !added) return added;
  const auto joined = Join(**process, options);
  if (!joined) return joined.error();
  if (*joined == Told::kEnd) return {};
  tendon::SetLogLevel(tendon::LogLevel::kInfo);
  if (Start(*share, **process, options) == Told::kGoOn) tendon::os::WaitForTermination();
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
