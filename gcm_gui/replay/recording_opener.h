#pragma once

#include <gcm_gui/replay/recording_notes.h>

#include <QObject>
#include <QString>
#include <QStringList>

class QMimeData;
class QWidget;

namespace tendon::gui {

/// Opens recordings, each in a window of its own, which is another process of this program: see
/// docs/decisions/025.
class RecordingOpener : public QObject {
  Q_OBJECT

 public:
  /// `program` is this program with its options; if it is empty, recordings cannot be opened.
  /// `folder` is that of the window's saved state. `window` must outlive it.
  RecordingOpener(QStringList program, const QString& folder, QWidget& window);

  [[nodiscard]] RecordingNotes& notes() { return notes_; }
  [[nodiscard]] bool isPossible() const { return !program_.isEmpty(); }

  /// Lets the user choose a file.
  void ask();
  void open(const QString& file);
  /// The recordings among dragged files.
  [[nodiscard]] static QStringList recordingsIn(const QMimeData& data);

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  const QStringList program_;
  RecordingNotes notes_;
  QWidget& window_;
};

}  // namespace tendon::gui
