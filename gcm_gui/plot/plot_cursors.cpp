#include <gcm_gui/plot/plot_cursors.h>

#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kGrab = 5;  // pixels on both sides of a cursor

}  // namespace

PlotCursors::PlotCursors(const PlotAxes& axes, const CurveSet& curves, SharedTimeAxis& time_axis)
    : axes_(axes), curves_(curves), time_axis_(time_axis), times_(time_axis.cursors()) {}

void PlotCursors::place(Cursor cursor, double x) {
  if (curves_.empty()) return;
  times_.set(cursor, time_axis_.window().shownAt(axes_.secondsAt(x)));
  time_axis_.touch();
  Q_EMIT shownChanged(true);
}

std::optional<Cursor> PlotCursors::at(double x) const {
  const TimeWindow& window = time_axis_.window();
  for (const Cursor cursor : kCursors) {
    const auto time = times_.time(cursor);
    if (time && std::abs(axes_.columnOf(window.pointOf(*time)) - x) <= kGrab) return cursor;
  }
  return std::nullopt;
}

void PlotCursors::show(bool shown) {
  times_.clear();
  if (shown) {
    place(Cursor::kA, axes_.columns() / 3);
    place(Cursor::kB, axes_.columns() * 2 / 3);
  }
  time_axis_.touch();
  Q_EMIT shownChanged(times_.any());
}

}  // namespace tendon::gui
