#pragma once

#include <QString>
#include <QStringList>
#include <vector>

namespace tendon::gui {

/// Something this program is made of, and the terms under which it is.
struct Library {
  QString name;
  QString version;  ///< empty where it does not say
  QString licence;  ///< its short name
  QStringList texts;

  /// All its terms, one text after the other.
  [[nodiscard]] QString terms() const;
};

/// Tendon itself first.
[[nodiscard]] std::vector<Library> LibrariesInUse();

/// A line each: what somebody who helps wants to know.
[[nodiscard]] QString VersionsText();

}  // namespace tendon::gui
