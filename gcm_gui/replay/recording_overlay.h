#pragma once

#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/replay/recorded_signals.h>

#include <QList>
#include <QObject>
#include <QString>

class QWidget;

namespace tendon::gui {

class PlotPanel;
class RecordingNotes;

/// Curves of recordings beside the curves of the shown system. The user chooses a file and its
/// signals, or drags signals from the window of a recording.
class RecordingOverlay : public QObject {
  Q_OBJECT

 public:
  /// All must outlive it.
  RecordingOverlay(PlotPanel& panel, RecordingNotes& notes, QWidget& window);

  /// The source of the rows of recorded curves.
  [[nodiscard]] RecordedSignals& source() { return source_; }
  /// Lets the user choose a file, and then signals for the current plot.
  void ask();
  void askForSignals(const QString& file);

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  void add(const QList<CurveKey>& keys, qint64 begin_ns);

  PlotPanel& panel_;
  RecordingNotes& notes_;
  QWidget& window_;
  RecordedSignals source_;
};

}  // namespace tendon::gui
