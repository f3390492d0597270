#include <gcm_gui/replay/recording_overlay.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/plot/series/time_shift.h>
#include <gcm_gui/replay/recorded_signal_dialog.h>
#include <gcm_gui/replay/recording_notes.h>
#include <gcm_gui/replay/recording_opener.h>

#include <QFileDialog>
#include <QSet>

namespace tendon::gui {

RecordingOverlay::RecordingOverlay(PlotPanel& panel, RecordingNotes& notes, QWidget& window)
    : QObject(&window),
      panel_(panel),
      notes_(notes),
      window_(window),
      source_([&panel](const QString& recording) { return panel.seenOf(recording); }) {
  connect(&panel, &PlotPanel::recordingRequested, this, &RecordingOverlay::ask);
  connect(&source_, &RecordedSignals::opened, &panel, Guarded(&panel, &PlotPanel::setRecordedTime));
  connect(&source_, &RecordedSignals::readAgain, &panel,
          Guarded(&panel, &PlotPanel::removeSamples));
  connect(&source_, &RecordedSignals::notice, this, &RecordingOverlay::notice);
}

void RecordingOverlay::ask() {
  QFileDialog& dialog = ShowRecordingDialog(
      window_, notes_, Words::tr("Add a curve of a recording"), QStringLiteral("addRecording"));
  connect(&dialog, &QFileDialog::fileSelected, this, &RecordingOverlay::askForSignals);
}

void RecordingOverlay::askForSignals(const QString& file) {
  QSet<QString> plotted;
  for (const auto& curve : panel_.currentPlot().curves().curves()) {
    if (!curve->isRecorded()) plotted << curve->path();
  }
  auto* dialog = new RecordedSignalDialog(file, plotted, &window_);
  connect(dialog, &RecordedSignalDialog::chosen, this, &RecordingOverlay::add);
  dialog->open();
}

void RecordingOverlay::add(const QList<CurveKey>& keys, qint64 begin_ns) {
  const QString recording = RecordingOf(keys.front().path);
  PlotView& view = panel_.currentPlot();
  if (!view.recordedCurves().isOnPage(recording)) {
    view.recordedCurves().align(recording, MovedTime(begin_ns, -WallOffset()),
                                RecordedCurves::Edge::kLeft);
  }
  for (const CurveKey& key : keys) panel_.addSignal(key.path, key.unit);
  notes_.addRecent(recording);
  Q_EMIT notice(Words::tr("%1 is dashed: drag it in time with Ctrl, or press T to set its shift")
                    .arg(RecordingName(keys.front().path)));
}

}  // namespace tendon::gui
