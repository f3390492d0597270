#pragma once

#include <chrono>
#include <cstdint>

namespace tendon::gui {

/// The part of time that a plot shows. Live: the last seconds, with the present at the right edge.
/// Held: a part chosen by the user, while further samples arrive.
///
/// Seconds are relative to origin(): the present when live, the time of holding when held.
///
/// A sweeping window, as on an oscilloscope, has a fixed axis that begins at origin(), and a head
/// that moves from left to right. Left of the head is the present pass; right of it the previous
/// pass, until the head overwrites it. Zooming or moving returns to a window whose time runs from
/// left to right.
class TimeWindow {
 public:
  enum class Motion { kScroll, kSweep };
  static constexpr double kLongest = 48 * 3600;  ///< s

  [[nodiscard]] bool isLive() const { return live_; }
  [[nodiscard]] std::chrono::nanoseconds length() const { return length_; }
  /// Keeps the right edge; a held window stays held.
  void setLength(std::chrono::nanoseconds length);

  /// How it moves while live.
  void setMotion(Motion motion);
  [[nodiscard]] Motion motion() const { return motion_; }
  /// True if it sweeps live, or is held in the middle of a sweep.
  [[nodiscard]] bool isSweeping() const { return motion_ == Motion::kSweep && !is_unfolded_; }
  /// The axis position of a sweeping window's head.
  [[nodiscard]] double head() const { return secondsAt(head_ns_); }

  /// Moves a live window by whole columns of a canvas that is `columns` wide, until the present is
  /// at the right edge; each column keeps its samples, so the curve does not flicker. Returns true
  /// if it has moved. A held window stays.
  bool follow(std::int64_t now_ns, double columns);
  void hold() { live_ = false; }
  void goLive();

  // These hold the window. `at_s` keeps its position on the canvas.
  void zoom(double factor, double at_s);
  void pan(double by_s);
  void show(double from_s, double to_s);

  [[nodiscard]] std::int64_t origin() const { return origin_ns_; }  ///< ns
  [[nodiscard]] double from() const { return from_s_; }
  [[nodiscard]] double to() const { return to_s_; }
  /// The time of an axis position.
  [[nodiscard]] std::int64_t timeAt(double seconds) const;
  /// The axis position of a time.
  [[nodiscard]] double secondsAt(std::int64_t time_ns) const;

  /// The time that is visible at an axis position. Right of the head of a sweeping window it is one
  /// window length before timeAt().
  [[nodiscard]] std::int64_t shownAt(double seconds) const;
  /// The axis position at which a time is visible.
  [[nodiscard]] double pointOf(std::int64_t time_ns) const;
  // The earliest and latest time that it shows.
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
