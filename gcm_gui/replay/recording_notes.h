#pragma once

#include <gcm_gui/files/saved_settings.h>

#include <QList>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// What a user keeps about recordings: those that were opened lately, and the marks in each. GUI
/// thread.
class RecordingNotes {
 public:
  static constexpr qsizetype kMostRecent = 8;

  /// `folder` is that of the window's saved state; if it is empty, nothing is kept.
  explicit RecordingNotes(const QString& folder);

  /// The files, latest first; those that are gone are left out.
  [[nodiscard]] QStringList recent() const;
  void addRecent(const QString& file);
  /// Times in ns since 1970.
  [[nodiscard]] QList<std::int64_t> marks(const QString& file) const;
  void setMarks(const QString& file, const QList<std::int64_t>& marks);

 private:
  std::optional<SavedSettings> kept_;
};

}  // namespace tendon::gui
