#include <tendon/gcm/lifecycle/class_check.h>

#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/running_system.h>
#include <tendon/gcm/system/system_index.h>
#include <tendon/gcm/text.h>
#include <tendon/manager/component_registry.h>
#include <tendon/payload/json.h>

#include <algorithm>

namespace tendon {
namespace {

/// Returns true if the component already matches its description in the file and need not be
/// created.
bool IsMadeAs(const SystemFile::Component* running, const SystemFile::Component& wanted) {
  return running != nullptr && running->class_name == wanted.class_name &&
         (wanted.library.empty() || running->library == wanted.library) &&
         running->configuration == wanted.configuration;
}

bool IsLoaded(const message::Classes& known, const std::string& library) {
  return std::ranges::find(known.classes, library, &ClassDescription::library) !=
         known.classes.end();
}

/// Returns true if a component of the process needs a plug-in that is not loaded. The classes of
/// this plug-in are not known yet.
bool LoadsMore(const message::Classes& known, const SystemFile::Process& process) {
  return std::ranges::any_of(process.components, [&known](const auto& component) {
    return !component.library.empty() && !IsLoaded(known, component.library);
  });
}

/// Returns the plug-in with the class of the component: from the file, or, if the file names none,
/// from the present component.
std::string LibraryOf(const SystemFile::Component& component, const ProcessEntry& process) {
  if (!component.library.empty()) return component.library;
  const auto now = process.components.find(component.name);
  return now == process.components.end() ? std::string() : now->second.library;
}

/// Returns the process from the file, without the components that cannot be created. If such a
/// component exists now, the result has the present component instead.
SystemFile::Process Feasible(const SystemFile::Process& process, const SystemIndex& running,
                             const message::Classes& known, std::vector<std::string>& obstacles) {
  SystemFile::Process feasible = process;
  feasible.components.clear();
  for (const SystemFile::Component& component : process.components) {
    const auto* now = running.FindComponent(process.name, component.name);
    const bool is_unknown = component.library.empty() && LoadsMore(known, process);
    const bool is_free = IsMadeAs(now, component) || component.class_name.empty() || is_unknown;
    const auto checked = is_free ? Result<void>()
                                 : CheckCreation(known, {.process = process.name,
                                                         .component = component.name,
                                                         .class_name = component.class_name,
                                                         .library = component.library,
                                                         .configuration = component.configuration});
    if (checked) {
      feasible.components.push_back(component);
      continue;
    }
    obstacles.push_back(process.name + "/" + component.name +
                        " cannot be created as the file says: " + checked.error().message +
                        (now == nullptr ? "" : "; this component is not changed"));
    if (now != nullptr) feasible.components.push_back(*now);
  }
  return feasible;
}

/// Adds a note for each plug-in of the wanted components whose file has changed since a present
/// process loaded it. Prefers `known` to the catalogue, because `known` is newer.
void AddOldPlugins(const Catalogue& catalogue, const SystemFile& wanted, const KnownClasses& known,
                   std::vector<std::string>& notes) {
  for (const SystemFile::Process& process : wanted.processes) {
    const ProcessEntry* entry = catalogue.FindProcess(process.name);
    if (entry == nullptr || !IsPresent(entry->process)) continue;
    const auto asked = known.find(process.name);
    const auto& loaded = asked == known.end() ? entry->process.plugins : asked->second.loaded;
    for (const PluginDescription& plugin : loaded) {
      const bool is_meant = std::ranges::any_of(process.components, [&](const auto& component) {
        return LibraryOf(component, *entry) == plugin.name;
      });
      if (is_meant && plugin.state != PluginState::kCurrent) {
        notes.push_back(OutdatedPluginText(process.name, plugin));
      }
    }
  }
}

}  // namespace

Result<void> CheckPlugIn(const message::Classes& known, const std::string& library) {
  if (auto checked = CheckName("plug-in", library); !checked) return checked;
  const bool is_there = std::ranges::find(known.plugins, library) != known.plugins.end();
  if (is_there || IsLoaded(known, library)) return {};
  return Error{ErrorCode::kNotFound,
               "no plug-in '" + library + "'" + DidYouMean(library, known.plugins)};
}

Result<void> CheckCreation(const message::Classes& known, const message::LifecycleOrder& order) {
  if (!order.library.empty()) {
    if (auto checked = CheckPlugIn(known, order.library); !checked) return checked;
    if (!IsLoaded(known, order.library)) return {};
  }
  std::vector<std::string> names;
  std::vector<const ClassDescription*> found;
  for (const ClassDescription& one : known.classes) {
    if (!order.library.empty() && one.library != order.library) continue;
    names.push_back(one.name);
    if (one.name == order.class_name) found.push_back(&one);
  }
  if (found.empty()) {
    const std::string where = order.library.empty() ? " that is loaded" : " in " + order.library;
    const std::string next = order.library.empty()
                                 ? "; load the plug-in that has this class, or give the name of "
                                   "that plug-in as the library of the component"
                                 : "";
    const auto* loaded = FindNamed(known.loaded, order.library);
    const std::string old = loaded == nullptr || loaded->state == PluginState::kCurrent
                                ? ""
                                : "; " + OutdatedPluginText(order.process, *loaded);
    return Error{ErrorCode::kNotFound, "process '" + order.process + "' has no class '" +
                                           order.class_name + "'" + where +
                                           DidYouMean(order.class_name, names) + next + old};
  }
  if (found.size() > 1) {
    return Error{ErrorCode::kInvalid, "the libraries '" + found[0]->library + "' and '" +
                                          found[1]->library + "' both have a class '" +
                                          order.class_name +
                                          "'; give the name of the library to use"};
  }
  return CheckConfiguration(*found.front(), order.configuration);
}

Result<void> CheckConfiguration(const ClassDescription& of, const std::string& configuration) {
  if (configuration.empty()) return {};
  const std::string what = "class '" + of.name + "': ";
  const auto schema = Schema::Parse(of.configuration);
  if (!schema) return Error{schema.error().code, what + schema.error().message};
  if (schema->is_none()) {
    return Error{ErrorCode::kInvalid,
                 what + "this class takes no configuration, got " + Printable(configuration, 64)};
  }
  const auto merged = ComponentRegistry::MergeConfiguration(of.defaults, configuration);
  const auto body = merged ? FromJson(*schema, *merged) : merged.error();
  return body ? Result<void>() : Error{body.error().code, what + body.error().message};
}

std::vector<std::string> ProcessesToAsk(const Catalogue& catalogue, const SystemFile& wanted) {
  const RunningSystem running = SystemOf(catalogue, wanted.name);
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

Plan MakeCheckedPlan(const Catalogue& catalogue, const SystemFile& wanted,
                     const KnownClasses& known) {
  const RunningSystem running = SystemOf(catalogue, wanted.name);
  const SystemIndex now(running.file);
  SystemFile feasible = wanted;
  std::vector<std::string> obstacles;
  for (SystemFile::Process& process : feasible.processes) {
    const auto classes = known.find(process.name);
    if (classes == known.end()) continue;
    process = Feasible(process, now, classes->second, obstacles);
  }
  Plan plan = MakePlan(catalogue, feasible);
  AddOldPlugins(catalogue, wanted, known, plan.notes);
  if (!obstacles.empty()) plan.refusal = ErrorCode::kFailed;
  plan.obstacles.insert(plan.obstacles.begin(), obstacles.begin(), obstacles.end());
  return plan;
}

}  // namespace tendon
