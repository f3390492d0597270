#include <gcm_console/catalogue/glob.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/path.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lifecycle/lifecycle_plan.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system/start_order.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace console {
namespace {

using program::ExitCode;
using tendon::Catalogue;
using tendon::Error;
using tendon::ErrorCode;
using tendon::LifecycleVerb;
using tendon::Path;
using tendon::Result;
using tendon::message::LifecycleOrder;

struct LifecycleArguments {
  std::vector<std::string> patterns;
  bool dry_run = false;
  bool yes = false;
  bool is_strict = false;
};

/// A verb in its forms for messages: "stop", "stopped".
struct LifecycleVerbForms {
  LifecycleVerb verb;
  std::string_view infinitive;
  std::string_view done;
};

/// The selected components or processes, and the number of matches of a glob that were left out
/// because the verb does not apply to them.
struct Targets {
  std::vector<Path> paths;
  std::size_t left_out = 0;
  bool has_glob = false;

  /// Adds a path. A path that was given without a glob is always added, regardless of its state.
  void Add(const Path& path, bool is_of_glob, bool is_of_use) {
    if (std::ranges::find(paths, path) != paths.end()) return;
    if (is_of_glob && !is_of_use) {
      ++left_out;
    } else {
      paths.push_back(path);
    }
  }
};

/// Sorts `paths` by the position of their names in `order`. Names that are missing in `order` come
/// last.
template <typename Name, typename NameOf>
void PutInOrder(const std::vector<Name>& order, NameOf name_of, std::vector<Path>& paths) {
  std::map<Name, std::size_t> places;
  for (std::size_t i = 0; i < order.size(); ++i) places.emplace(order[i], i);
  std::ranges::stable_sort(paths, {}, [&](const Path& path) {
    const auto place = places.find(name_of(path));
    return place == places.end() ? order.size() : place->second;
  });
}

/// Sorts clients before their servers, so that a server can still execute the last commands of its
/// clients.
void PutClientsFirst(const Catalogue& catalogue, std::vector<Path>& paths) {
  PutInOrder(
      tendon::EndOrder(tendon::SystemOf(catalogue, "").file),
      [](const Path& path) { return tendon::ComponentPath(path.process, path.component); }, paths);
}

/// Sorts client processes before the processes of their servers.
void PutClientProcessesFirst(const Catalogue& catalogue, std::vector<Path>& paths) {
  PutInOrder(
      tendon::ProcessEndOrder(tendon::SystemOf(catalogue, "").file),
      [](const Path& path) { return path.process; }, paths);
}

LifecycleOrder OrderOf(LifecycleVerb verb, const Path& path) {
  return {.verb = verb, .process = path.process, .component = path.component};
}

Result<Targets> FindTargets(const Catalogue& catalogue, LifecycleVerb verb,
                            const LifecycleArguments& arguments) {
  Targets targets;
  for (const std::string& pattern : arguments.patterns) {
    const bool is_glob = IsGlob(pattern);
    const auto found = LookUpComponents(catalogue, pattern);
    if (!found) return found.error();
    targets.has_glob = targets.has_glob || is_glob;
    for (const Path& path : *found) {
      targets.Add(path, is_glob, CheckLifecycleOrder(catalogue, OrderOf(verb, path)).ok());
    }
  }
  const bool is_end = verb == LifecycleVerb::kStop || verb == LifecycleVerb::kRemove;
  if (is_end && targets.paths.size() > 1) PutClientsFirst(catalogue, targets.paths);
  return targets;
}

Result<void> SendOrder(Context& context, const LifecycleOrder& order) {
  return context.Ask<void>(
      [&](tendon::GcmClient& client, auto handler) {
        client.ExecuteLifecycleOrder(order, std::move(handler));
      },
      tendon::GcmClient::kLifecycleOrderTimeouts);
}

void PrintLeftOut(Context& context, const Targets& targets, std::string_view done) {
  if (targets.left_out == 0) return;
  const bool is_one = targets.left_out == 1;
  context.err() << "gcm: " << tendon::Counted(targets.left_out, "match is", "matches are")
                << " skipped, because " << (is_one ? "it" : "they") << " cannot be " << done
                << " in " << (is_one ? "its" : "their") << " current state\n";
}

/// If a glob matches several objects, asks a user at a terminal for confirmation. `what` describes
/// the objects.
bool IsConfirmed(const Context& context, std::string_view infinitive, std::string_view what,
                 const Targets& targets, const LifecycleArguments& arguments) {
  if (!targets.has_glob || targets.paths.size() < 2 || arguments.yes || arguments.dry_run) {
    return true;
  }
  std::string question = std::string(infinitive) + ' ' + std::to_string(targets.paths.size()) +
                         ' ' + std::string(what) + ':';
  for (const Path& path : targets.paths) question += ' ' + ToString(path);
  return Confirm(context, question);
}

/// Asks for confirmation if necessary, executes the verb for each target and prints the outcomes.
/// `what` describes the targets. `execute` is called with each path, and its result is the outcome.
Result<ExitCode> ExecuteForEach(Context& context, const VerbForms& forms, std::string_view what,
                                const Targets& targets, const LifecycleArguments& arguments,
                                const std::function<Result<void>(const Path&)>& execute) {
  PrintLeftOut(context, targets, forms.participle);
  if (!IsConfirmed(context, forms.verb, what, targets, arguments)) return Declined();
  std::vector<Outcome> outcomes;
  for (const Path& path : targets.paths) outcomes.push_back({ToString(path), execute(path)});
  PrintOutcomes(context, forms, outcomes);
  return ExitCodeOf(outcomes);
}

Result<ExitCode> ExecuteLifecycleVerb(Context& context, const LifecycleVerbForms& forms,
                                      const LifecycleArguments& arguments) {
  const auto client = context.Client();
  if (!client) return client.error();
  if (auto allowed = CheckRole(context); arguments.dry_run && !allowed) return allowed.error();
  const Catalogue catalogue = (*client)->catalogue();
  const auto targets = FindTargets(catalogue, forms.verb, arguments);
  if (!targets) return targets.error();
  const auto execute = [&](const Path& path) {
    LifecycleOrder order = OrderOf(forms.verb, path);
    order.is_strict = arguments.is_strict;
    return arguments.dry_run ? CheckLifecycleOrder(catalogue, order) : SendOrder(context, order);
  };
  return ExecuteForEach(context, {forms.infinitive, forms.done, arguments.dry_run}, "components",
                        *targets, arguments, execute);
}

Verb LifecycleVerbOf(std::string name, std::string summary, LifecycleVerbForms forms) {
  return {
      std::move(name), std::move(summary), [forms](CLI::App& app) -> Verb::Run {
        auto arguments = std::make_shared<LifecycleArguments>();
        WithKind(app.add_option("components", arguments->patterns,
                                "process/component, or a pattern such as robot/*; ** matches all"),
                 WordKind::kComponent)
            ->required();
        AddDryRun(app, arguments->dry_run);
        app.add_flag("--yes", arguments->yes, "do not ask, even if a pattern matches several");
        if (forms.verb == LifecycleVerb::kStart) {
          app.add_flag(
              "--strict", arguments->is_strict,
              "do not start a component while an interface that it needs is not connected; "
              "without this option, the component runs and waits for the connection");
        }
        return [=](Context& context) { return ExecuteLifecycleVerb(context, forms, *arguments); };
      }};
}

using Ours = std::optional<tendon::message::Children>;

/// A verb that applies to whole processes.
struct ProcessVerbForms {
  std::string_view infinitive;
  std::string_view done;
  bool needs_ours;
  /// Checks whether the action is possible. `ours` are the processes that the GCM has started;
  /// empty if the GCM does not report them.
  Result<void> (*check)(const Catalogue& catalogue, const Ours& ours, const std::string& process);
  Result<void> (*carry)(Context& context, const std::string& process);
};

Result<void> CheckKill(const Catalogue& catalogue, const Ours& ours, const std::string& process) {
  const auto entry = LookUpProcess(catalogue, process);
  if (!entry) return entry.error();
  const bool is_ours =
      ours && std::ranges::count(ours->processes, process, &tendon::message::Child::process) > 0;
  // A process that this GCM has started can be ended in any state: it may hang or may wait for a
  // restart.
  if (is_ours) return {};
  if (auto present = RequirePresent((*entry)->process); !present || !ours) return present;
  return Error{ErrorCode::kFailed,
               "process '" + process +
                   "' was not started by this GCM: end the process where it was started"};
}

Result<void> Kill(Context& context, const std::string& process) {
  const tendon::message::ProcessOrder order{.verb = tendon::ProcessVerb::kKill, .process = process};
  return context.Ask<void>(
      [&](tendon::GcmClient& client, auto handler) {
        client.ExecuteProcessOrder(order, std::move(handler));
      },
      tendon::GcmClient::kProcessOrderTimeouts);
}

Result<void> CheckForget(const Catalogue& catalogue, const Ours& /*ours*/,
                         const std::string& process) {
  const auto entry = LookUpProcess(catalogue, process);
  if (!entry) return entry.error();
  if ((*entry)->process.state == tendon::ProcessState::kStarting) {
    return Error{
        ErrorCode::kFailed,
        "process '" + process + "' is starting; only a process that is gone can be forgotten"};
  }
  if (!IsPresent((*entry)->process)) return {};
  return Error{
      ErrorCode::kFailed,
      "process '" + process + "' is not gone; only a process that is gone can be forgotten"};
}

Result<void> Forget(Context& context, const std::string& process) {
  return context.Ask<void>(
      [&](tendon::GcmClient& client, auto handler) { client.Forget(process, std::move(handler)); });
}

/// Finds the processes that match. Unknown names, and processes that the GCM has not started, are
/// kept: the GCM refuses them and gives the reason.
Result<Targets> FindProcesses(const Catalogue& catalogue, const Ours& ours,
                              const ProcessVerbForms& forms, const LifecycleArguments& arguments) {
  Targets targets;
  for (const std::string& pattern : arguments.patterns) {
    if (!IsGlob(pattern)) {
      targets.Add({.process = pattern}, false, true);
      continue;
    }
    targets.has_glob = true;
    bool is_found = false;
    for (const auto& [name, entry] : catalogue.processes()) {
      if (!tendon::MatchesGlob(pattern, name)) continue;
      is_found = true;
      // A present process that this GCM has not started is kept, because the error of the GCM says
      // where to end it.
      const bool is_of_use =
          forms.check(catalogue, ours, name).ok() || forms.check(catalogue, {}, name).ok();
      targets.Add({.process = name}, true, is_of_use);
    }
    if (is_found) continue;
    return Error{ErrorCode::kNotFound,
                 "no process matches '" + pattern + "'; to list all processes: gcm ls"};
  }
  if (targets.paths.size() > 1) PutClientProcessesFirst(catalogue, targets.paths);
  return targets;
}

/// Returns the processes that the GCM has started.
Result<Ours> AskForOurs(Context& context) {
  auto children = context.Ask<tendon::message::Children>(
      [](tendon::GcmClient& client, auto handler) { client.GetChildren(handler); });
  return children ? Result<Ours>(*std::move(children)) : children.error();
}

Result<ExitCode> ExecuteProcessVerb(Context& context, const ProcessVerbForms& forms,
                                    const LifecycleArguments& arguments) {
  const auto client = context.Client();
  if (!client) return client.error();
  if (auto allowed = CheckRole(context); arguments.dry_run && !allowed) return allowed.error();
  const Catalogue catalogue = (*client)->catalogue();
  const auto ours = forms.needs_ours ? AskForOurs(context) : Result<Ours>(Ours());
  if (!ours) return ours.error();
  const auto targets = FindProcesses(catalogue, *ours, forms, arguments);
  if (!targets) return targets.error();
  const auto execute = [&](const Path& path) {
    return arguments.dry_run ? forms.check(catalogue, *ours, path.process)
                             : forms.carry(context, path.process);
  };
  return ExecuteForEach(context, {forms.infinitive, forms.done, arguments.dry_run}, "processes",
                        *targets, arguments, execute);
}

Verb ProcessVerb(std::string summary, const ProcessVerbForms& forms) {
  return {std::string(forms.infinitive), std::move(summary), [forms](CLI::App& app) -> Verb::Run {
            auto arguments = std::make_shared<LifecycleArguments>();
            WithKind(app.add_option("processes", arguments->patterns,
                                    "names of processes, or a pattern such as desk*"),
                     WordKind::kProcess)
                ->required();
            AddDryRun(app, arguments->dry_run);
            app.add_flag("--yes", arguments->yes, "do not ask, even if a pattern matches several");
            return [=](Context& context) { return ExecuteProcessVerb(context, forms, *arguments); };
          }};
}

}  // namespace

std::vector<Verb> LifecycleVerbs() {
  return {
      LifecycleVerbOf("start", "start or resume components",
                      {LifecycleVerb::kStart, "start", "started"}),
      LifecycleVerbOf("suspend", "pause the cycles of components; to resume them: gcm start",
                      {LifecycleVerb::kSuspend, "suspend", "suspended"}),
      LifecycleVerbOf("stop", "stop components", {LifecycleVerb::kStop, "stop", "stopped"}),
      LifecycleVerbOf("restart", "stop components that run, and start them again",
                      {LifecycleVerb::kRestart, "restart", "restarted"}),
      LifecycleVerbOf("rm", "remove components, with their connections",
                      {LifecycleVerb::kRemove, "remove", "removed"}),
      ProcessVerb("end processes that the GCM has started, with all their components",
                  {"kill", "ended", true, &CheckKill, &Kill}),
      ProcessVerb("remove processes that have ended or are lost from the catalogue",
                  {"forget", "forgotten", false, &CheckForget, &Forget}),
  };
}

}  // namespace console
