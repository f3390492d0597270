#include <tendon/base/name.h>
#include <tendon/gcm/life/class_check.h>
#include <tendon/gcm/life/parameters.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system/system_index.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

/// Whether it is made as the file says, so that nobody is asked to make it.
bool IsMadeAs(const SystemFile::Component* running, const SystemFile::Component& wanted) {
  return running != nullptr && running->class_name == wanted.class_name &&
         (wanted.library.empty() || running->library == wanted.library) &&
         running->configuration == wanted.configuration;
}

bool IsLoaded(const message::Classes& known, const std::string& library) {
  return std::ranges::find(known.classes, library, &ClassDescription::library) !=
         known.classes.end();
}

/// Whether making the process's components loads plug-ins, whose classes nobody knows yet.
bool LoadsMore(const message::Classes& known, const SystemFile::Process& process) {
  return std::ranges::any_of(process.components, [&known](const auto& component) {
    return !component.library.empty() && !IsLoaded(known, component.library);
  });
}

/// What the file says of the process, or what runs where that could not be made.
SystemFile::Process Feasible(const SystemFile::Process& process, const SystemIndex& running,
                             const message::Classes& known, std::vector<std::string>& obstacles) {
  SystemFile::Process feasible = process;
  feasible.components.clear();
  for (const SystemFile::Component& component : process.components) {
    const auto* now = running.FindComponent(process.name, component.name);
    const bool is_unknown = component.library.empty() && LoadsMore(known, process);
    const bool is_free = IsMadeAs(now, component) || component.class_name.empty() || is_unknown;
    const auto checked = is_free ? Result<void>() : CheckClass(known, process.name, component);
    if (checked) {
      feasible.components.push_back(component);
      continue;
    }
    obstacles.push_back(process.name + "/" + component.name + " cannot be made as the file says: " +
                        checked.error().message + (now == nullptr ? "" : "; it stays as it is"));
    if (now != nullptr) feasible.components.push_back(*now);
  }
  return feasible;
}

}  // namespace

Result<void> CheckClass(const message::Classes& known, const std::string& process,
                        const SystemFile::Component& component) {
  const std::string& library = component.library;
  const auto is_of_library = [&library](const ClassDescription& one) {
    return library.empty() || one.library == library;
  };
  const bool is_loaded = IsLoaded(known, library);
  const bool is_there = std::ranges::find(known.plugins, library) != known.plugins.end();
  if (!library.empty() && !is_loaded && !is_there) {
    return Error{ErrorCode::kNotFound, "process '" + process + "' has no plug-in '" + library +
                                           "'" + DidYouMean(library, known.plugins)};
  }
  std::vector<std::string> names;
  for (const ClassDescription& one : known.classes) {
    if (!is_of_library(one)) continue;
    names.push_back(one.name);
    if (one.name != component.class_name) continue;
    return component.configuration.empty() ? Result<void>()
                                           : CheckConfiguration(one, component.configuration);
  }
  if (!is_loaded && !library.empty()) return {};
  return Error{ErrorCode::kNotFound,
               (library.empty() ? "process '" + process + "'" : "plug-in '" + library + "'") +
                   " has no class '" + component.class_name + "'" +
                   DidYouMean(component.class_name, names)};
}

std::vector<std::string> ProcessesToAsk(const Catalog& catalog, const SystemFile& wanted) {
  const RunningSystem running = SystemOf(catalog, wanted.name);
  const SystemIndex now(running.file);
  std::vector<std::string> all;
  for (const SystemFile::Process& process : wanted.processes) {
    const bool has_to_make = std::ranges::any_of(process.components, [&](const auto& component) {
      return !IsMadeAs(now.FindComponent(process.name, component.name), component);
    });
    if (has_to_make && now.FindProcess(process.name) != nullptr) all.push_back(process.name);
  }
  return all;
}

Plan MakeCheckedPlan(const Catalog& catalog, const SystemFile& wanted, const KnownClasses& known) {
  const RunningSystem running = SystemOf(catalog, wanted.name);
  const SystemIndex now(running.file);
  SystemFile feasible = wanted;
  std::vector<std::string> obstacles;
  for (SystemFile::Process& process : feasible.processes) {
    const auto classes = known.find(process.name);
    if (classes == known.end()) continue;
    process = Feasible(process, now, classes->second, obstacles);
  }
  Plan plan = MakePlan(catalog, feasible);
  plan.obstacles.insert(plan.obstacles.begin(), obstacles.begin(), obstacles.end());
  return plan;
}

}  // namespace tendon
