#include <tendon/gcm/lookup.h>
#include <tendon/gcm/server/hand_backs.h>

#include <utility>

namespace tendon::server {
namespace {

std::string ClassOf(const Catalog& catalog, const InterfaceName& end) {
  const ComponentDescription* component = catalog.FindComponent(end.process, end.component);
  return component == nullptr ? std::string() : component->class_name;
}

}  // namespace

void HandBacks::Keep(const Catalog& catalog, const std::string& process) {
  const ProcessEntry* entry = catalog.FindProcess(process);
  if (entry == nullptr) return;
  for (const auto& [id, connection] : entry->connections) {
    std::erase_if(kept_, [&required = connection.required](const Kept& kept) {
      return kept.wire.required == required;
    });
    kept_.push_back({{connection.required, connection.provided},
                     ClassOf(catalog, connection.required),
                     ClassOf(catalog, connection.provided)});
  }
}

void HandBacks::Drop(const std::string& process) {
  std::erase_if(kept_, [&](const Kept& kept) { return kept.wire.required.process == process; });
}

std::vector<message::Wire> HandBacks::TakeDue(const Catalog& catalog) {
  std::vector<message::Wire> due;
  std::erase_if(kept_, [&](const Kept& kept) {
    const Readiness readiness = Judge(kept, catalog);
    if (readiness == Readiness::kDue) due.push_back(kept.wire);
    return readiness != Readiness::kWaiting;
  });
  return due;
}

HandBacks::Readiness HandBacks::Judge(const Kept& kept, const Catalog& catalog) {
  const auto& [required, provided] = kept.wire;
  const ProcessEntry* owner = catalog.FindProcess(required.process);
  if (owner == nullptr || !IsPresent(owner->process)) return Readiness::kWaiting;
  if (catalog.FindRequired(required) == nullptr || catalog.FindProvided(provided) == nullptr) {
    return Readiness::kWaiting;
  }
  const bool same_classes =
      ClassOf(catalog, required) == kept.required_class &&
      (kept.provided_class.empty() || ClassOf(catalog, provided) == kept.provided_class);
  if (!same_classes || catalog.FindConnection(required) != nullptr) return Readiness::kPointless;
  return Readiness::kDue;
}

}  // namespace tendon::server
