#pragma once

#include <chrono>
#include <cstdint>

namespace tendon::gui {

/// A time span in ns, both ends included.
struct TimeSpan {
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;

  bool operator==(const TimeSpan&) const = default;
};

/// The span of time that a plot shows. A live window shows the last seconds, with the present at
/// the right edge. A held window shows a span chosen by the user, while further samples arrive.
///
/// Positions on the axis are in seconds relative to origin(). The origin of a live window is the
/// present. The origin of a held window is the time at which the window was held.
///
/// A sweeping window works like an oscilloscope: the axis is fixed and begins at origin(), and a
/// head moves from left to right. The present pass is to the left of the head. The previous pass is
/// to the right, until the head overwrites it. Zooming or moving the window ends the sweep: time
/// then runs from left to right again.
class TimeWindow {
 public:
  enum class Motion { kScroll, kSweep };
  static constexpr double kLongest = 48 * 3600;  ///< s

  [[nodiscard]] bool isLive() const { return live_; }
  [[nodiscard]] std::chrono::nanoseconds length() const { return length_; }
  /// Sets the length and keeps the right edge. A held window stays held.
  void setLength(std::chrono::nanoseconds length);

  /// Sets how the window moves while it is live.
  void setMotion(Motion motion);
  [[nodiscard]] Motion motion() const { return motion_; }
  /// Returns true if the window is live and sweeps, or if it was held in the middle of a sweep.
  [[nodiscard]] bool isSweeping() const { return motion_ == Motion::kSweep && !is_unfolded_; }
  /// Returns the axis position of the head of a sweeping window.
  [[nodiscard]] double head() const { return secondsAt(head_ns_); }

  /// Moves a live window until the present is at the right edge. The canvas is `columns` wide. The
  /// window moves by whole columns: each column keeps its samples, so the curve does not flicker.
  /// Returns true if the window has moved. A held window does not move.
  bool follow(std::int64_t now_ns, double columns);
  void hold() { live_ = false; }
  void goLive();

  // zoom(), pan() and show() hold the window. In zoom(), the time at `at_s` keeps its position on
  // the canvas.
  void zoom(double factor, double at_s);
  void pan(double by_s);
  void show(double from_s, double to_s);

  [[nodiscard]] std::int64_t origin() const { return origin_ns_; }  ///< ns
  [[nodiscard]] double from() const { return from_s_; }
  [[nodiscard]] double to() const { return to_s_; }
  /// Returns the time at an axis position.
  [[nodiscard]] std::int64_t timeAt(double seconds) const;
  /// Returns the axis position of a time.
  [[nodiscard]] double secondsAt(std::int64_t time_ns) const;

  /// Returns the time that is visible at an axis position. To the right of the head of a sweeping
  /// window, this is one window length before timeAt().
  [[nodiscard]] std::int64_t shownAt(double seconds) const;
  /// Returns the axis position at which a time is visible.
  [[nodiscard]] double pointOf(std::int64_t time_ns) const;
  // The earliest and the latest time that the window shows.
  [[nodiscard]] std::int64_t firstTime() const;
  [[nodiscard]] std::int64_t lastTime() const;

  bool operator==(const TimeWindow&) const = default;

 private:
  [[nodiscard]] double lengthInSeconds() const;
  void rewind();
  void unfold();

  std::chrono::nanoseconds length_ = std::chrono::seconds(30);
  std::int64_t origin_ns_ = 0;
  double from_s_ = -30;
  double to_s_ = 0;
  bool live_ = true;
  Motion motion_ = Motion::kScroll;
  bool is_unfolded_ = false;
  std::int64_t head_ns_ = 0;
};

}  // namespace tendon::gui
