#include <gcm_gui/diagnosis/refused_connections.h>

#include <utility>

namespace tendon::gui {

const RefusedConnection* RefusedConnections::find(const InterfaceName& required) const {
  const auto it = refused_.find(required);
  return it == refused_.end() ? nullptr : &it->second;
}

void RefusedConnections::onActionFinished(const Action& finished) {
  if (finished.required.interface.empty()) return;
  const bool wanted =
      finished.verb == Action::Verb::kConnect || finished.verb == Action::Verb::kReplace;
  ByRequired fresh = refused_;
  if (finished.outcome == Action::Outcome::kDone) {
    fresh.erase(finished.required);
  } else if (wanted) {
    fresh[finished.required] = {finished.provided, finished.refusal, finished.when};
  }
  if (fresh == refused_) return;
  refused_ = std::move(fresh);
  Q_EMIT changed();
}

void RefusedConnections::update(const Catalogue& catalogue) {
  const auto is_over = [&](const auto& entry) {
    const auto& [required, refused] = entry;
    const auto* connection = catalogue.FindConnection(required);
    const bool is_made = connection != nullptr && connection->provided == refused.provided;
    return is_made || catalogue.FindRequired(required) == nullptr;
  };
  if (std::erase_if(refused_, is_over) > 0) Q_EMIT changed();
}

}  // namespace tendon::gui
