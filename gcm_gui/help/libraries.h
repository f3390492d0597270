#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace tendon::gui {

/// A library that this program uses, and its licence.
struct Library {
  QString name;
  QString version;  ///< empty if unknown
  QString licence;  ///< the short name
  QStringList texts;

  /// The texts of all its terms.
  [[nodiscard]] QString terms() const;
};

/// Begins with Tendon itself.
[[nodiscard]] std::vector<Library> LibrariesInUse();

/// One version per line, for support requests.
[[nodiscard]] QString VersionsText();

}  // namespace tendon::gui
