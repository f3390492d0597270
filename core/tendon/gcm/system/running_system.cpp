#include <tendon/gcm/system/running_system.h>

#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/system_index.h>
#include <tendon/middleware/hello.h>

#include <algorithm>
#include <set>
#include <utility>

namespace tendon {
namespace {

SystemFile::Component ComponentOf(const ComponentDescription& running) {
  SystemFile::Component component{.name = running.name,
                                  .class_name = running.class_name,
                                  .library = running.library,
                                  .configuration = running.configuration,
                                  .period = running.period,
                                  .state = running.state};
  if (component.class_name.empty()) {
    component.library.clear();
    component.configuration.clear();
    return component;
  }
  if (!running.thread.empty()) component.thread = running.thread.front();
  component.runs_after = running.leader;
  if (!component.runs_after.empty()) component.period = 0.0;  // it has its leader's period
  return component;
}

SystemFile::Process SavedProcessOf(const ProcessEntry& entry) {
  SystemFile::Process process{.name = entry.process.name, .components = {}};
  for (const auto& [name, component] : entry.components) {
    process.components.push_back(ComponentOf(component));
  }
  return process;
}

bool IsSaved(const ProcessEntry& entry, AbsentProcesses absent) {
  const bool is_there = absent == AbsentProcesses::kIncluded || IsPresent(entry.process);
  return is_there && entry.process.name != kGcmName;
}

void KeepIn(const SystemIndex& former, SystemFile::Process& saved) {
  const auto* before = former.FindProcess(saved.name);
  if (before == nullptr) return;
  saved.comment = before->comment;
  saved.start = before->start;
  for (SystemFile::Component& component : saved.components) {
    const auto* same = former.FindComponent(saved.name, component.name);
    if (same != nullptr) component.comment = same->comment;
  }
}

void Sort(SystemFile& file) {
  std::ranges::sort(file.processes, {}, &SystemFile::Process::name);
  std::ranges::sort(file.connections, {}, &SystemFile::Connection::required);
}

/// Copies absent processes and their connections.
std::vector<std::string> KeepAbsent(const SystemFile& former, RunningSystem& saved) {
  std::set<std::string> present;
  for (const SystemFile::Process& process : saved.file.processes) present.insert(process.name);
  std::vector<std::string> kept;
  for (const SystemFile::Process& process : former.processes) {
    if (present.contains(process.name)) continue;
    kept.push_back("process '" + process.name +
                   "' is not available now: kept as in the file, with " +
                   Counted(process.components.size(), "component", "components"));
    saved.file.processes.push_back(process);
  }
  for (const SystemFile::Connection& connection : former.connections) {
    if (!present.contains(connection.required.process)) saved.loose.push_back(connection);
  }
  const SystemIndex index(saved.file);
  std::vector<SystemFile::Connection> loose;
  for (const SystemFile::Connection& connection : saved.loose) {
    const auto& [process, component, interface] = connection.provided;
    const bool is_there = index.FindComponent(process, component) != nullptr;
    (is_there ? saved.file.connections : loose).push_back(connection);
  }
  saved.loose = std::move(loose);
  Sort(saved.file);
  return kept;
}

}  // namespace

RunningSystem SystemOf(const Catalogue& catalogue, const std::string& name,
                       AbsentProcesses absent) {
  RunningSystem running{.file = {.name = name, .processes = {}, .connections = {}}, .loose = {}};
  for (const auto& [process_name, entry] : catalogue.processes()) {
    if (IsSaved(entry, absent)) running.file.processes.push_back(SavedProcessOf(entry));
  }
  const SystemIndex index(running.file);
  for (const auto& [process_name, entry] : catalogue.processes()) {
    if (!IsSaved(entry, absent)) continue;
    for (const auto& [id, connection] : entry.connections) {
      const auto& [process, component, interface] = connection.provided;
      const bool is_there = index.FindComponent(process, component) != nullptr;
      auto& connections = is_there ? running.file.connections : running.loose;
      connections.push_back({connection.required, connection.provided});
    }
  }
  Sort(running.file);
  return running;
}

std::vector<std::string> RunningSystem::LeftOut() const {
  std::vector<std::string> sentences;
  for (const auto& [required, provided, comment] : loose) {
    sentences.push_back(ToString(required) + " -> " + ToString(provided) +
                        " is left out, because " + provided.process + "/" + provided.component +
                        " does not exist");
  }
  return sentences;
}

void SetStarts(const message::Children& children, SystemFile& file) {
  for (const auto& [name, restart] : children.processes) {
    const auto process = std::ranges::find(file.processes, name, &SystemFile::Process::name);
    if (process != file.processes.end()) process->start = {.restart = restart};
  }
}

std::vector<std::string> KeepFrom(const SystemFile& former, RunningSystem& saved) {
  std::vector<std::string> kept = KeepAbsent(former, saved);
  SystemFile& file = saved.file;
  const SystemIndex before(former);
  file.comment = former.comment;
  file.strict = former.strict;
  for (SystemFile::Process& process : file.processes) KeepIn(before, process);
  for (SystemFile::Connection& connection : file.connections) {
    const auto* same = before.FindConnection(connection.required);
    if (same != nullptr) connection.comment = same->comment;
  }
  const SystemIndex now(file);
  for (const auto& [path, position] : former.layout) {
    const std::size_t slash = path.find('/');
    const bool is_there = now.FindComponent(path.substr(0, slash), path.substr(slash + 1));
    if (is_there) file.layout.insert({path, position});
  }
  return kept;
}

}  // namespace tendon
