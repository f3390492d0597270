#pragma once

#include <chrono>
#include <cstdint>

namespace tendon::gui {

/// Which part of time a plot shows. Live: the last so many seconds, and now at the right edge.
/// Held: what the user has chosen, while samples go on arriving unseen.
///
/// Seconds count from origin(): now when live, the moment of holding when held.
///
/// Sweeping, as an oscilloscope does, the axis rests: it begins at origin(), and a head moves over
/// it from left to right. Left of the head is what came since; right of it what was there a length
/// ago, until the head has passed over it. Zooming and moving leave that picture for one in which
/// time goes on from left to right.
class TimeWindow {
 public:
  enum class Motion { kScroll, kSweep };

  [[nodiscard]] bool isLive() const { return live_; }
  [[nodiscard]] std::chrono::nanoseconds length() const { return length_; }
  /// The right edge stays; so does a held window held.
  void setLength(std::chrono::nanoseconds length);

  /// How it moves while it is live.
  void setMotion(Motion motion);
  [[nodiscard]] Motion motion() const { return motion_; }
  /// Live, or held as it was when it swept.
  [[nodiscard]] bool isSweeping() const { return motion_ == Motion::kSweep && !is_unfolded_; }
  /// Of a sweeping window, the point of the axis up to which it has come.
  [[nodiscard]] double head() const { return secondsAt(head_ns_); }

  /// Moves a live window until now is at its right edge, by whole columns of a canvas that is
  /// `columns` wide: then each column keeps its samples, and the curve glides without flicker.
  /// Returns whether it has moved. A held window stays.
  bool follow(std::int64_t now_ns, double columns);
  void hold() { live_ = false; }
  void goLive();

  // These hold the window. `at_s` stays where it is on the canvas.
  void zoom(double factor, double at_s);
  void pan(double by_s);
  void show(double from_s, double to_s);

  [[nodiscard]] std::int64_t origin() const { return origin_ns_; }  ///< ns
  [[nodiscard]] double from() const { return from_s_; }
  [[nodiscard]] double to() const { return to_s_; }
  /// Time of a point of the axis.
  [[nodiscard]] std::int64_t timeAt(double seconds) const;
  /// The point of the axis at a time.
  [[nodiscard]] double secondsAt(std::int64_t time_ns) const;

  /// Time of what is shown at a point of the axis: right of the head of a sweeping window that is a
  /// length before timeAt().
  [[nodiscard]] std::int64_t shownAt(double seconds) const;
  /// The point of the axis at which a time is shown.
  [[nodiscard]] double pointOf(std::int64_t time_ns) const;
  // All it shows lies between them.
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
