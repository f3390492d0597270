#include <gcm_gui/graph/layout/picture_updater.h>

#include <gcm_gui/graph/layout/affinities.h>
#include <gcm_gui/graph/layout/node_metrics.h>
#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <iterator>
#include <string>

namespace tendon::gui {
namespace {

NodePicture NodeOf(const ConnectionIndex& connections, const ProcessEntry& entry,
                   const ComponentDescription& component) {
  const std::string& process = entry.process.name;
  NodePicture node;
  node.name = ToQString(component.name);
  node.path = ToQString(process + '/' + component.name);
  node.state = component.state;
  node.waits = WaitsOf(connections, entry, component);
  for (const auto& required : component.required) {
    const InterfaceName name{process, component.name, required.name};
    const auto* connection = connections.Of(name);
    const bool active = connection != nullptr && connection->state == ConnectionState::kActive;
    node.required.push_back({{Side::kRequired, name}, active});
  }
  for (const auto& provided : component.provided) {
    const InterfaceName name{process, component.name, provided.name};
    node.provided.push_back({{Side::kProvided, name}, connections.Clients(name) > 0});
  }
  node.size = SizeOf(node);
  return node;
}

/// Returns the position of a name in a sorted list, or the position at which to insert the name.
template <typename Things>
auto FindByName(Things& things, const std::string& name) {
  return std::lower_bound(things.begin(), things.end(), name,
                          [](const auto& thing, const std::string& wanted) {
                            return thing.name.toStdString() < wanted;
                          });
}

template <typename Things>
bool IsAt(const Things& things, typename Things::const_iterator place, const std::string& name) {
  return place != things.end() && place->name == ToQString(name);
}

bool HaveSameEnds(const ConnectionDescription& a, const ConnectionDescription& b) {
  return a.required == b.required && a.provided == b.provided;
}

}  // namespace

GraphPicture PictureOf(const Catalogue& catalogue) {
  ChangedParts all;
  for (const auto& [name, entry] : catalogue.processes()) all.insert({name, {}});
  return PictureUpdater().update(catalogue, all);
}

const GraphPicture& PictureUpdater::update(const Catalogue& catalogue,
                                           const ChangedParts& touched) {
  const ConnectionIndex connections(catalogue);
  bool other_interfaces = false;
  for (const ChangedPart& part : touched) {
    updatePart(catalogue, connections, part);
    if (takeInterfaces(catalogue, part)) other_interfaces = true;
  }
  const bool other_edges = takeEdges(catalogue);
  if (other_interfaces) fitting_ = FittingOf(catalogue);
  if (other_interfaces || other_edges) {
    picture_.affinities = AffinitiesOf(fitting_, picture_.edges);
  }
  return picture_;
}

void PictureUpdater::updatePart(const Catalogue& catalogue, const ConnectionIndex& connections,
                                const ChangedPart& part) {
  const ProcessEntry* entry = catalogue.FindProcess(part.process);
  auto process = FindByName(picture_.processes, part.process);
  const bool known = IsAt(picture_.processes, process, part.process);
  if (entry == nullptr) {
    if (known) picture_.processes.erase(process);
    return;
  }
  if (!known || part.component.empty()) {
    ProcessPicture fresh{ToQString(part.process),
                         entry->process.state,
                         entry->process.since,
                         {},
                         WidthOfTitle(ToQString(part.process))};
    for (const auto& [name, component] : entry->components) {
      fresh.nodes.push_back(NodeOf(connections, *entry, component));
    }
    if (!known) process = picture_.processes.emplace(process);
    *process = std::move(fresh);
    return;
  }
  const auto component = entry->components.find(part.component);
  auto node = FindByName(process->nodes, part.component);
  const bool has_node = IsAt(process->nodes, node, part.component);
  if (component == entry->components.end()) {
    if (has_node) process->nodes.erase(node);
    return;
  }
  if (!has_node) node = process->nodes.emplace(node);
  *node = NodeOf(connections, *entry, component->second);
}

bool PictureUpdater::takeInterfaces(const Catalogue& catalogue, const ChangedPart& part) {
  const ProcessEntry* entry = catalogue.FindProcess(part.process);
  const auto description = [&](const std::string& name) -> const ComponentDescription* {
    return entry == nullptr ? nullptr : catalogue.FindComponent(part.process, name);
  };
  bool changed = false;
  // First visits the known interfaces, because some of them may be gone; then the present ones.
  for (auto it = interfaces_.lower_bound(part);
       it != interfaces_.end() && it->first.process == part.process;) {
    if (!part.component.empty() && it->first.component != part.component) break;
    const bool gone = description(it->first.component) == nullptr;
    changed = changed || gone;
    it = gone ? interfaces_.erase(it) : std::next(it);
  }
  if (entry == nullptr) return changed;
  for (const auto& [name, component] : entry->components) {
    if (!part.component.empty() && name != part.component) continue;
    Interfaces fresh{component.required, component.provided};
    Interfaces& known = interfaces_[{part.process, name}];
    if (known == fresh) continue;
    known = std::move(fresh);
    changed = true;
  }
  return changed;
}

bool PictureUpdater::takeEdges(const Catalogue& catalogue) {
  std::vector<ConnectionDescription> fresh = catalogue.connections();
  const bool same = std::equal(fresh.begin(), fresh.end(), picture_.edges.begin(),
                               picture_.edges.end(), HaveSameEnds);
  picture_.edges = std::move(fresh);
  return !same;
}

}  // namespace tendon::gui
