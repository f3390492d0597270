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

/// A component that has changed or whose connections have changed. If `component` is empty, the
/// whole process has changed.
struct ChangedPart {
  std::string process;
  std::string component;

  auto operator<=>(const ChangedPart&) const = default;
};
using ChangedParts = std::set<ChangedPart>;

/// The window's copy of the catalogue. All views use it. GUI thread.
class CatalogueStore : public QObject {
  Q_OBJECT

 public:
  /// The maximum number of changed components that are announced in one step. A changed process
  /// counts as all its components. More changes are announced in several steps.
  static constexpr std::size_t kMaxAtOnce = 100;

  explicit CatalogueStore(QObject* parent = nullptr);

  [[nodiscard]] const Catalogue& catalogue() const { return catalogue_; }

  /// Returns the time, in ns since 1970, at which a component entered its present state. Empty if
  /// this was before the window was connected.
  [[nodiscard]] std::optional<std::int64_t> stateSince(const std::string& process,
                                                       const std::string& component) const;

  /// Replaces the catalogue by a snapshot. All parts of the old and of the new catalogue count as
  /// touched.
  void replace(Catalogue catalogue);
  /// Applies the next changes. If a change is missing, ignores the later changes, because a
  /// snapshot will follow.
  void apply(const std::vector<CatalogueChange>& changes);

 Q_SIGNALS:
  /// Announces changes that have arrived together. If they touch many components, they are
  /// announced in several steps from the event loop, so that no step blocks the window.
  void changed(const tendon::Catalogue& catalogue, const tendon::gui::ChangedParts& touched);
  /// Emitted when FindSchema() knows more types of the catalogue.
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
  QTimer next_{this};  // active while some changes are not announced
};

}  // namespace tendon::gui
