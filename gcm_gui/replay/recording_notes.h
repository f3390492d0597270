#pragma once

#include <gcm_gui/files/saved_settings.h>

#include <QList>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// The user's notes about recordings: the files that were opened recently, and the marks in each
/// file. To find the marks of a file, pass its path without symbolic links, as in RecordingFacts.
/// GUI thread.
class RecordingNotes {
 public:
  static constexpr qsizetype kMaxRecent = 8;

  /// `folder` is the folder of the window's saved state; if it is empty, nothing is saved.
  explicit RecordingNotes(const QString& folder);

  /// Returns those of the latest kMaxRecent files that still exist, latest first.
  [[nodiscard]] QStringList recent() const;
  /// `file` is an absolute path.
  void addRecent(const QString& file);
  /// The times of the marks, in ns since 1970.
  [[nodiscard]] QList<std::int64_t> marks(const QString& file) const;
  void setMarks(const QString& file, const QList<std::int64_t>& marks);

 private:
  std::optional<SavedSettings> kept_;
};

}  // namespace tendon::gui
