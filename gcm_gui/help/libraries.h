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

  /// Returns the text of all licence terms.
  [[nodiscard]] QString terms() const;
};

/// Returns all libraries, starting with Tendon itself.
[[nodiscard]] std::vector<Library> LibrariesInUse();

/// Returns the versions of all parts, one per line, for support requests.
[[nodiscard]] QString VersionsText();

}  // namespace tendon::gui
