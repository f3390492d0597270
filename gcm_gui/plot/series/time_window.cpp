#include <gcm_gui/plot/series/time_window.h>

#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kShortest = 1e-4;      // s; beyond it the nanoseconds would show
constexpr double kLongest = 48 * 3600;  // s
constexpr double kNanoseconds = 1e9;

}  // namespace

void TimeWindow::setLength(std::chrono::nanoseconds length) {
  length_ = length;
  from_s_ = to_s_ - static_cast<double>(length_.count()) / kNanoseconds;
}

bool TimeWindow::follow(std::int64_t now_ns, double columns) {
  if (!live_) return false;
  const double column_ns = static_cast<double>(length_.count()) / columns;
  const double column = std::ceil(static_cast<double>(now_ns) / column_ns);
  const auto origin = static_cast<std::int64_t>(std::llround(column * column_ns));
  const bool moved = origin != origin_ns_;
  origin_ns_ = origin;
  return moved;
}

void TimeWindow::goLive() {
  live_ = true;
  from_s_ = -static_cast<double>(length_.count()) / kNanoseconds;
  to_s_ = 0;
}

void TimeWindow::zoom(double factor, double at_s) {
  const double span = to_s_ - from_s_;
  const double bounded = std::clamp(span * factor, kShortest, kLongest) / span;
  show(at_s - (at_s - from_s_) * bounded, at_s + (to_s_ - at_s) * bounded);
}

void TimeWindow::pan(double by_s) { show(from_s_ + by_s, to_s_ + by_s); }

void TimeWindow::show(double from_s, double to_s) {
  live_ = false;
  from_s_ = from_s;
  to_s_ = std::max(to_s, from_s + kShortest);
}

std::int64_t TimeWindow::timeAt(double seconds) const {
  return origin_ns_ + static_cast<std::int64_t>(std::llround(seconds * kNanoseconds));
}

double TimeWindow::secondsAt(std::int64_t time_ns) const {
  return static_cast<double>(time_ns - origin_ns_) / kNanoseconds;
}

}  // namespace tendon::gui
