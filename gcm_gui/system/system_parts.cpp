#include <gcm_gui/system/system_parts.h>

#include <tendon/gcm/system/running_system.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

template <typename T, typename Same>
T* Find(std::vector<T>& list, Same same) {
  const auto found = std::find_if(list.begin(), list.end(), same);
  return found == list.end() ? nullptr : &*found;
}

auto Named(const std::string& name) {
  return [name](const auto& one) { return one.name == name; };
}

/// Makes one element of `list` equal to `from`. If `from` is null, removes the element.
template <typename T, typename Same>
void Take(std::vector<T>& list, const T* from, Same same) {
  T* const there = Find(list, same);
  if (from == nullptr) {
    std::erase_if(list, same);
  } else if (there != nullptr) {
    *there = *from;
  } else {
    list.push_back(*from);
  }
}

void TakeConnection(SystemFile& base, const SystemFile& from, const std::string& required) {
  const auto same = [&required](const auto& one) { return ToString(one.required) == required; };
  const auto found = std::find_if(from.connections.begin(), from.connections.end(), same);
  Take(base.connections, found == from.connections.end() ? nullptr : &*found, same);
}

void TakeProcess(SystemFile& base, const SystemFile& from, const std::string& name) {
  const auto* wanted = from.FindProcess(name);
  auto* const there = Find(base.processes, Named(name));
  if (wanted != nullptr && there != nullptr) {
    there->start = wanted->start;
    return;
  }
  Take(base.processes, wanted, Named(name));
  const auto is_of_it = [&name](const auto& one) { return one.required.process == name; };
  std::erase_if(base.connections, is_of_it);
  std::copy_if(from.connections.begin(), from.connections.end(),
               std::back_inserter(base.connections), is_of_it);
}

void TakeComponent(SystemFile& base, const SystemFile& from, const std::string& path) {
  const std::size_t slash = path.find('/');
  const std::string process = path.substr(0, slash);
  const std::string name = path.substr(slash + 1);
  const auto* wanted = from.FindComponent(process, name);
  auto* there = Find(base.processes, Named(process));
  if (there == nullptr) {
    if (wanted == nullptr) return;
    base.processes.push_back({.name = process, .components = {}});
    there = &base.processes.back();
  }
  Take(there->components, wanted, Named(name));
}

}  // namespace

SystemFile WithPartOf(SystemFile base, const SystemFile& from, const std::string& what) {
  const std::size_t space = what.find(' ');
  const std::string kind = what.substr(0, space);
  std::string path = space == std::string::npos ? std::string() : what.substr(space + 1);
  path = path.substr(0, path.find(" -> "));  // a connection is named by its required interface
  if (kind == "process") TakeProcess(base, from, path);
  if (kind == "component") TakeComponent(base, from, path);
  if (kind == "connection") TakeConnection(base, from, path);
  return base;
}

SystemFile WholeSystem(const Catalogue& catalogue) {
  RunningSystem running = SystemOf(catalogue, "running");
  auto& connections = running.file.connections;
  connections.insert(connections.end(), running.loose.begin(), running.loose.end());
  return std::move(running.file);
}

}  // namespace tendon::gui
