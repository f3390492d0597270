#include <gcm_gui/plot/recorded_curves.h>

#include <gcm_gui/plot/series/time_shift.h>

#include <cmath>
#include <limits>

namespace tendon::gui {

RecordedCurves::RecordedCurves(const PlotAxes& axes, const CurveSet& curves,
                               SharedTimeAxis& time_axis)
    : axes_(axes), curves_(curves), time_axis_(time_axis) {}

QStringList RecordedCurves::recordings() const {
  QStringList recordings;
  for (const auto& curve : curves_.curves()) {
    if (curve->isRecorded() && !recordings.contains(curve->recording())) {
      recordings << curve->recording();
    }
  }
  return recordings;
}

QString RecordedCurves::recordingAt(const QPointF& point) const {
  const std::int64_t time = time_axis_.window().shownAt(axes_.secondsAt(point.x()));
  QString nearest;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& curve : curves_.curves()) {
    if (!curve->isRecorded() || !curve->isVisible()) continue;
    if (nearest.isEmpty()) nearest = curve->recording();
    const auto value = curve->numberAt(time);
    if (!value) continue;
    const UnitAxis& axis = curves_.axisOf(*curve);
    const double place = axis.frame.placeOf(value->nearest() - axis.frame.base, curves_.scale());
    const double fraction = (place - axis.range.low) / axis.range.span();
    const double distance = std::abs(axes_.rowOf(fraction) - point.y());
    if (distance >= least) continue;
    least = distance;
    nearest = curve->recording();
  }
  return nearest;
}

bool RecordedCurves::isOnPage(const QString& recording) const {
  return time_axis_.isShown(recording);
}

void RecordedCurves::move(const QString& recording, double pixels) {
  time_axis_.remember(SharedTimeAxis::Gesture::kShift);
  const TimeWindow& window = time_axis_.window();
  const double by_ns = (window.to() - window.from()) * pixels / axes_.columns() * 1e9;
  changeShift(recording, MovedTime(shift(recording), std::llround(by_ns)));
  Q_EMIT moved(recording, shift(recording));
}

void RecordedCurves::setShift(const QString& recording, std::int64_t shift_ns) {
  if (time_axis_.shift(recording) == shift_ns) return;
  const bool is_shown = isOnPage(recording);
  if (is_shown) time_axis_.remember(SharedTimeAxis::Gesture::kOnce);
  changeShift(recording, shift_ns);
  if (is_shown) Q_EMIT moved(recording, shift(recording));
}

void RecordedCurves::changeShift(const QString& recording, std::int64_t shift_ns) {
  time_axis_.setShift(recording, shift_ns);
  time_axis_.touch();
  takeShifts();
}

std::int64_t RecordedCurves::shift(const QString& recording) const {
  return time_axis_.shift(recording).value_or(0);
}

void RecordedCurves::align(const QString& recording, std::int64_t time_ns, Edge edge) {
  time_axis_.follow(axes_.screenColumns());
  const TimeWindow& window = time_axis_.window();
  const std::int64_t place = edge == Edge::kLeft ? window.firstTime() : window.lastTime();
  setShift(recording, MovedTime(place, -time_ns));
}

bool RecordedCurves::askForShift(const QString& recording) {
  for (const auto& curve : curves_.curves()) {
    if (!curve->isRecorded() || curve->recording() != recording) continue;
    Q_EMIT editorRequested(curve->path());
    return true;
  }
  return false;
}

void RecordedCurves::takeShifts() {
  for (const auto& curve : curves_.curves()) {
    if (curve->isRecorded()) curve->setShift(shift(curve->recording()));
  }
}

}  // namespace tendon::gui
