#pragma once

#include <tendon/gcm/catalogue.h>

#include <QObject>
#include <QTimer>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace tendon::gui {

/// A component that has changed, or a component with a changed connection. An empty component means
/// the whole process.
struct ChangedPart {
  std::string process;
  std::string component;

  auto operator<=>(const ChangedPart&) const = default;
};
using ChangedParts = std::set<ChangedPart>;

/// The window's copy of the catalogue, shared by all views. GUI thread.
class CatalogueStore : public QObject {
  Q_OBJECT

 public:
  /// The number of changed components (plus the rest of a process) that are announced in one step;
  /// more need several steps.
  static constexpr std::size_t kMostAtOnce = 100;

  explicit CatalogueStore(QObject* parent = nullptr);

  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }

  /// The time, ns since 1970, at which a component entered its state; empty if that was before this
  /// window was connected.
  [[nodiscard]] std::optional<std::int64_t> stateSince(const std::string& process,
                                                       const std::string& component) const;

  /// Takes a snapshot; all old and new parts count as touched.
  void replace(Catalogue catalogue);
  /// Takes the next changes. Ignores changes after a missing one: a snapshot will follow.
  void apply(const std::vector<CatalogueChange>& changes);
  /// True if not all changes were announced to the views yet.
  [[nodiscard]] bool isAnnouncing() const { return !unannounced_.empty(); }

 Q_SIGNALS:
  /// Announces changes that arrived together; if they touch many components, in steps from the
  /// event loop, so that no step blocks the window.
  void changed(const tendon::Catalogue& catalogue, const tendon::gui::ChangedParts& touched);
  /// FindSchema() now knows more types of the catalogue.
  void typesLearned();

 private:
  struct KnownState {
    ComponentState state = ComponentState::kConstructed;
    std::optional<std::int64_t> since;
  };

  void announce();
  void noteState(const std::string& process, const ComponentDescription& component,
                 std::optional<std::int64_t> changed_at);

  Catalogue catalogue_;
  std::map<ChangedPart, KnownState> states_;
  ChangedParts unannounced_;
  QTimer next_;
};

}  // namespace tendon::gui
