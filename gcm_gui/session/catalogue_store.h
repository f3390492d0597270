#pragma once

#include <tendon/gcm/catalog.h>

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

/// A component of which something has changed, its interfaces' connections included. Without a
/// component it is the whole process.
struct TouchedPart {
  std::string process;
  std::string component;

  auto operator<=>(const TouchedPart&) const = default;
};
using Touched = std::set<TouchedPart>;

/// The window's copy of the catalogue: every view shows this one. Lives in the GUI thread.
class CatalogueStore : public QObject {
  Q_OBJECT

 public:
  /// More components than this, at most by the rest of a process, are told of in several steps.
  static constexpr std::size_t kMostAtOnce = 100;

  explicit CatalogueStore(QObject* parent = nullptr);

  [[nodiscard]] const Catalog& catalogue() const { return catalogue_; }

  /// Since when a component is in its state, ns since 1970; nothing where this window was not there
  /// when it changed.
  [[nodiscard]] std::optional<std::int64_t> stateSince(const std::string& process,
                                                       const std::string& component) const;

  /// A snapshot: all of the old and the new one counts as touched.
  void replace(Catalog catalogue);
  /// The next changes; those that do not follow are left out, and a snapshot will come.
  void apply(const std::vector<CatalogChange>& changes);
  /// The views have not been told of everything yet.
  [[nodiscard]] bool isTelling() const { return !untold_.empty(); }

 Q_SIGNALS:
  /// Once for the changes that arrived together; where they touch many components, step by step
  /// from the event loop, so that no step holds up the window.
  void changed(const tendon::Catalog& catalogue, const tendon::gui::Touched& touched);
  /// FindSchema() knows more of the catalogue's types than before.
  void typesLearned();

 private:
  struct KnownState {
    ComponentState state = ComponentState::kConstructed;
    std::optional<std::int64_t> since;
  };

  void tell();
  void noteState(const std::string& process, const ComponentDescription& component,
                 std::optional<std::int64_t> changed_at);

  Catalog catalogue_;
  std::map<TouchedPart, KnownState> states_;
  Touched untold_;
  QTimer next_;
};

}  // namespace tendon::gui
