#include <gcm_gui/plot/series/time_window.h>

#include <algorithm>
#include <cmath>

namespace tendon::gui {
namespace {

constexpr double kShortest = 1e-4;  // s; with a shorter window, single nanoseconds would be visible
constexpr double kNanoseconds = 1e9;

}  // namespace

double TimeWindow::lengthInSeconds() const {
  return static_cast<double>(length_.count()) / kNanoseconds;
}

void TimeWindow::setLength(std::chrono::nanoseconds length) {
  const bool sweeps_on = live_ && isSweeping();
  if (!sweeps_on && isSweeping()) unfold();
  length_ = length;
  if (sweeps_on) return rewind();
  from_s_ = to_s_ - lengthInSeconds();
}

void TimeWindow::setMotion(Motion motion) {
  if (motion == motion_) return;
  if (!live_) unfold();
  motion_ = motion;
  if (live_) rewind();
}

// Resets the axis as in a live window.
void TimeWindow::rewind() {
  is_unfolded_ = false;
  from_s_ = motion_ == Motion::kSweep ? 0 : -lengthInSeconds();
  to_s_ = from_s_ + lengthInSeconds();
}

bool TimeWindow::follow(std::int64_t now_ns, double columns) {
  if (!live_) return false;
  const double column_ns = static_cast<double>(length_.count()) / columns;
  const double column = std::ceil(static_cast<double>(now_ns) / column_ns);
  const auto head = static_cast<std::int64_t>(std::llround(column * column_ns));
  const bool moved = head != head_ns_;
  head_ns_ = head;
  origin_ns_ = head;
  if (motion_ == Motion::kSweep) {
    const std::int64_t length = length_.count();
    const std::int64_t into = (head % length + length) % length;
    origin_ns_ = head - into;
  }
  return moved;
}

void TimeWindow::goLive() {
  live_ = true;
  rewind();
}

// Ends a sweep: time again runs from left to right over the axis, up to the head.
void TimeWindow::unfold() {
  live_ = false;
  const bool was_sweeping = isSweeping();
  is_unfolded_ = true;
  if (!was_sweeping) return;
  origin_ns_ = head_ns_;
  from_s_ = -lengthInSeconds();
  to_s_ = 0;
}

void TimeWindow::zoom(double factor, double at_s) {
  const std::int64_t at_ns = shownAt(at_s);
  unfold();
  const double at = secondsAt(at_ns);
  const double span = to_s_ - from_s_;
  const double bounded = std::clamp(span * factor, kShortest, kLongest) / span;
  show(at - (at - from_s_) * bounded, at + (to_s_ - at) * bounded);
}

void TimeWindow::pan(double by_s) {
  unfold();
  show(from_s_ + by_s, to_s_ + by_s);
}

void TimeWindow::show(double from_s, double to_s) {
  const auto [first, last] = std::minmax({shownAt(from_s), shownAt(to_s)});
  const bool was_sweeping = isSweeping();
  unfold();
  from_s_ = was_sweeping ? secondsAt(first) : from_s;
  to_s_ = std::max(was_sweeping ? secondsAt(last) : to_s, from_s_ + kShortest);
}

std::int64_t TimeWindow::timeAt(double seconds) const {
  return origin_ns_ + static_cast<std::int64_t>(std::llround(seconds * kNanoseconds));
}

double TimeWindow::secondsAt(std::int64_t time_ns) const {
  return static_cast<double>(time_ns - origin_ns_) / kNanoseconds;
}

std::int64_t TimeWindow::shownAt(double seconds) const {
  const bool is_former = isSweeping() && seconds > head();
  return timeAt(seconds) - (is_former ? length_.count() : 0);
}

double TimeWindow::pointOf(std::int64_t time_ns) const {
  const double seconds = secondsAt(time_ns);
  return isSweeping() && seconds < 0 ? seconds + lengthInSeconds() : seconds;
}

std::int64_t TimeWindow::firstTime() const {
  return isSweeping() ? head_ns_ - length_.count() : timeAt(from_s_);
}

std::int64_t TimeWindow::lastTime() const { return isSweeping() ? head_ns_ : timeAt(to_s_); }

}  // namespace tendon::gui
