#include <gcm_gui/session/catalogue_store.h>

#include <gcm_gui/models/text.h>

#include <utility>

namespace tendon::gui {
namespace {

void Touch(ChangedParts& touched, const ConnectionDescription& connection) {
  touched.insert({connection.required.process, connection.required.component});
  touched.insert({connection.provided.process, connection.provided.component});
}

/// Adds both interfaces of each connection of a process, because the rows of both show the
/// connection.
void TouchConnections(ChangedParts& touched, const ProcessEntry& entry) {
  for (const auto& [id, connection] : entry.connections) Touch(touched, connection);
}

/// Adds the parts that `change` touches. `before` is the catalogue before the change is applied.
void Touch(ChangedParts& touched, const Catalogue& before, const CatalogueChange& change) {
  const ProcessEntry* entry = before.FindProcess(change.process);
  switch (change.kind) {
    case CatalogueChange::Kind::kProcess:
    case CatalogueChange::Kind::kProcessRemoved:
      touched.insert({change.process, {}});
      if (entry) TouchConnections(touched, *entry);
      break;
    case CatalogueChange::Kind::kComponent:
      for (const auto& component : change.components) {
        touched.insert({change.process, component.name});
      }
      break;
    case CatalogueChange::Kind::kComponentRemoved:
      touched.insert({change.process, change.component});
      break;
    case CatalogueChange::Kind::kConnection:
      for (const auto& connection : change.connections) Touch(touched, connection);
      break;
    case CatalogueChange::Kind::kConnectionRemoved:
      if (!entry) break;
      if (const auto it = entry->connections.find(change.connection);
          it != entry->connections.end()) {
        Touch(touched, it->second);
      }
      break;
  }
}

void TouchAll(ChangedParts& touched, const Catalogue& catalogue) {
  for (const auto& [name, entry] : catalogue.processes()) {
    touched.insert({name, {}});
    TouchConnections(touched, entry);
  }
}

/// Removes about `most` components from the front of `parts` and returns them. A whole process
/// counts as all its components.
ChangedParts TakeSome(ChangedParts& parts, const Catalogue& catalogue, std::size_t most) {
  ChangedParts some;
  for (std::size_t count = 0; !parts.empty() && count < most;) {
    const ChangedPart part = *parts.begin();
    const auto same_process = [&](const ChangedPart& other) {
      return other.process == part.process;
    };
    const ProcessEntry* entry = catalogue.FindProcess(part.process);
    count += part.component.empty() && entry != nullptr ? entry->components.size() + 1 : 1;
    if (part.component.empty()) {
      while (!parts.empty() && same_process(*parts.begin())) parts.erase(parts.begin());
      some.insert(part);
    } else {
      some.insert(parts.extract(parts.begin()));
    }
  }
  return some;
}

}  // namespace

CatalogueStore::CatalogueStore(QObject* parent) : QObject(parent) {
  next_.setSingleShot(true);
  connect(&next_, &QTimer::timeout, this, &CatalogueStore::announce);
}

void CatalogueStore::announce() {
  const ChangedParts some = TakeSome(unannounced_, catalogue_, kMaxAtOnce);
  if (!unannounced_.empty()) next_.start();
  Q_EMIT changed(catalogue_, some);
}

void CatalogueStore::noteState(const std::string& process, const ComponentDescription& component,
                               std::optional<std::int64_t> changed_at) {
  const auto [known, is_new] = states_.try_emplace(ChangedPart{process, component.name});
  if (!is_new && known->second.state == component.state) return;
  known->second.state = component.state;
  known->second.since = is_new ? std::nullopt : changed_at;
}

std::optional<std::int64_t> CatalogueStore::stateSince(const std::string& process,
                                                       const std::string& component) const {
  const auto known = states_.find(ChangedPart{process, component});
  return known == states_.end() ? std::nullopt : known->second.since;
}

void CatalogueStore::replace(Catalogue catalogue) {
  std::erase_if(states_, [&](const auto& known) {
    return catalogue.FindComponent(known.first.process, known.first.component) == nullptr;
  });
  for (const auto& [name, entry] : catalogue.processes()) {
    for (const auto& [unused, component] : entry.components) {
      noteState(name, component, std::nullopt);  // the time of the last change is unknown
    }
  }
  TouchAll(unannounced_, catalogue_);
  TouchAll(unannounced_, catalogue);
  catalogue_ = std::move(catalogue);
  announce();
}

void CatalogueStore::apply(const std::vector<CatalogueChange>& changes) {
  for (const auto& change : changes) {
    ChangedParts here;
    Touch(here, catalogue_, change);
    if (!catalogue_.Apply(change)) continue;
    unannounced_.merge(here);
    for (const auto& component : change.components)
      noteState(change.process, component, WallClock());
    if (change.kind == CatalogueChange::Kind::kComponentRemoved) {
      states_.erase(ChangedPart{change.process, change.component});
    }
  }
  if (!unannounced_.empty()) announce();
}

}  // namespace tendon::gui
