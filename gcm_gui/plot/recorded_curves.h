#pragma once

#include <gcm_gui/plot/canvas/plot_axes.h>
#include <gcm_gui/plot/series/curve_set.h>
#include <gcm_gui/plot/shared_time_axis.h>

#include <QObject>
#include <QPointF>
#include <QString>
#include <QStringList>
#include <cstdint>

namespace tendon::gui {

/// The curves of one plot that show recordings, and the shifts of these recordings in time. All
/// plots with the same time axis show a recording with the same shift. A recording is named by its
/// file. GUI thread.
class RecordedCurves : public QObject {
  Q_OBJECT

 public:
  enum class Edge { kLeft, kRight };

  /// All arguments must outlive this object.
  RecordedCurves(const PlotAxes& axes, const CurveSet& curves, SharedTimeAxis& time_axis);

  /// The files of the recordings that this plot shows.
  [[nodiscard]] QStringList recordings() const;
  /// Returns the recording whose curve is nearest to this point of the canvas; empty if there is no
  /// visible recorded curve.
  [[nodiscard]] QString recordingAt(const QPointF& point) const;
  /// True if this plot, or another one with this time axis, shows a curve of the recording.
  [[nodiscard]] bool isOnPage(const QString& recording) const;

  /// Moves the curves of a recording by `pixels`, to the right if they are above 0. The visible
  /// time does not change.
  void move(const QString& recording, double pixels);
  /// Sets the time that is added to the times of a recording. This is a step of the history if a
  /// curve of the recording is already shown.
  void setShift(const QString& recording, std::int64_t shift_ns);
  [[nodiscard]] std::int64_t shift(const QString& recording) const;
  /// Sets the shift so that a time of the recording is at an edge of the view. The time is on the
  /// plots' clock, without the recording's shift.
  void align(const QString& recording, std::int64_t time_ns, Edge edge);
  /// Asks for the editor of a curve of this recording. Returns false if the plot shows none.
  bool askForShift(const QString& recording);
  /// Gives the curves the shifts that their recordings have on the time axis.
  void takeShifts();

 Q_SIGNALS:
  /// Emitted when the user has moved a recording, with its new shift.
  void moved(const QString& recording, qint64 shift_ns);
  /// Emitted when the user wants the editor of the curve with this path.
  void editorRequested(const QString& path);

 private:
  void changeShift(const QString& recording, std::int64_t shift_ns);

  const PlotAxes& axes_;
  const CurveSet& curves_;
  SharedTimeAxis& time_axis_;
};

}  // namespace tendon::gui
