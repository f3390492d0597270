#include <gcm_gui/session/catalogue_store.h>

#include <utility>

namespace tendon::gui {
namespace {

void Touch(Touched& touched, const ConnectionDescription& connection) {
  touched.insert({connection.required.process, connection.required.component});
  touched.insert({connection.provided.process, connection.provided.component});
}

/// Both ends of what a process is connected to: their rows say so.
void TouchConnections(Touched& touched, const ProcessEntry& entry) {
  for (const auto& [id, connection] : entry.connections) Touch(touched, connection);
}

/// What `change` touches in the catalogue before it is applied.
void Touch(Touched& touched, const Catalog& before, const CatalogChange& change) {
  const ProcessEntry* entry = before.FindProcess(change.process);
  switch (change.kind) {
    case CatalogChange::Kind::kProcess:
    case CatalogChange::Kind::kProcessRemoved:
      touched.insert({change.process, {}});
      if (entry) TouchConnections(touched, *entry);
      break;
    case CatalogChange::Kind::kComponent:
      for (const auto& component : change.components) {
        touched.insert({change.process, component.name});
      }
      break;
    case CatalogChange::Kind::kComponentRemoved:
      touched.insert({change.process, change.component});
      break;
    case CatalogChange::Kind::kConnection:
      for (const auto& connection : change.connections) Touch(touched, connection);
      break;
    case CatalogChange::Kind::kConnectionRemoved:
      if (!entry) break;
      if (const auto it = entry->connections.find(change.connection);
          it != entry->connections.end()) {
        Touch(touched, it->second);
      }
      break;
  }
}

void TouchAll(Touched& touched, const Catalog& catalogue) {
  for (const auto& [name, entry] : catalogue.processes()) {
    touched.insert({name, {}});
    TouchConnections(touched, entry);
  }
}

}  // namespace

void CatalogueStore::replace(Catalog catalogue) {
  Touched touched;
  TouchAll(touched, catalogue_);
  TouchAll(touched, catalogue);
  catalogue_ = std::move(catalogue);
  Q_EMIT changed(catalogue_, touched);
}

void CatalogueStore::apply(const std::vector<CatalogChange>& changes) {
  Touched touched;
  for (const auto& change : changes) {
    Touched here;
    Touch(here, catalogue_, change);
    if (catalogue_.Apply(change)) touched.merge(here);
  }
  if (!touched.empty()) Q_EMIT changed(catalogue_, touched);
}

}  // namespace tendon::gui
