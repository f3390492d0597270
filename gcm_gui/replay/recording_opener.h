#pragma once

#include <gcm_gui/replay/recording_notes.h>

#include <QObject>
#include <QString>
#include <QStringList>

class QFileDialog;
class QMimeData;
class QWidget;

namespace tendon::gui {

/// Opens each recording in its own window, which is another process of this program
/// (docs/decisions/025).
class RecordingOpener : public QObject {
  Q_OBJECT

 public:
  /// `program` is this program with its options; if it is empty, recordings cannot be opened.
  /// `folder` is the folder of the window's saved state. `window` must outlive this object.
  RecordingOpener(QStringList program, const QString& folder, QWidget& window);

  [[nodiscard]] RecordingNotes& notes() { return notes_; }
  [[nodiscard]] bool isPossible() const { return !program_.isEmpty(); }

  /// Lets the user choose a file.
  void ask();
  void open(const QString& file);
  /// Returns the recordings among the dragged files.
  [[nodiscard]] static QStringList recordingsIn(const QMimeData& data);

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  const QStringList program_;
  RecordingNotes notes_;
  QWidget& window_;
};

/// Shows a dialog, with this name, in which the user chooses a recording. It deletes itself.
QFileDialog& ShowRecordingDialog(QWidget& window, const RecordingNotes& notes, const QString& title,
                                 const QString& name);

}  // namespace tendon::gui
