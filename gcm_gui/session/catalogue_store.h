#pragma once

#include <tendon/gcm/catalog.h>

#include <QObject>
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
  using QObject::QObject;

  [[nodiscard]] const Catalog& catalogue() const { return catalogue_; }

  /// A snapshot: all of the old and the new one counts as touched.
  void replace(Catalog catalogue);
  /// The next changes; those that do not follow are left out, and a snapshot will come.
  void apply(const std::vector<CatalogChange>& changes);

 Q_SIGNALS:
  /// Once for all the changes that arrived together.
  void changed(const tendon::Catalog& catalogue, const tendon::gui::Touched& touched);

 private:
  Catalog catalogue_;
};

}  // namespace tendon::gui
