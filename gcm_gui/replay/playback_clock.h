#pragma once

#include <array>
#include <cstdint>

namespace tendon::gui {

/// The time of a recording while it is played. It runs with an adjustable speed, and can stop and
/// jump. All times are in ns: times of the recording since 1970, and `now` on any clock that never
/// goes back.
class PlaybackClock {
 public:
  /// The speeds that the user can choose, sorted.
  static constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};
  static constexpr double kSlowest = kSpeeds.front();
  static constexpr double kFastest = kSpeeds.back();
  /// The result of an update.
  enum class Turn {
    kNone,
    kEnded,       ///< the clock has reached the end and has stopped
    kBeganAgain,  ///< the clock has reached the end and runs from the start again
  };

  PlaybackClock() = default;
  /// Makes a clock that is stopped at the start. `last` must not be before `first`.
  PlaybackClock(std::int64_t first, std::int64_t last)
      : first_(first), last_(last), position_(first) {}

  [[nodiscard]] std::int64_t first() const { return first_; }
  [[nodiscard]] std::int64_t last() const { return last_; }
  [[nodiscard]] std::int64_t length() const { return last_ - first_; }

  [[nodiscard]] bool isPlaying() const { return is_playing_; }
  /// Starts the clock. If it is at the end, it starts from the beginning.
  void play(std::int64_t now);
  void pause(std::int64_t now);
  [[nodiscard]] double speed() const { return speed_; }
  /// Sets the speed, limited to kSlowest and kFastest. The position does not change.
  void setSpeed(double speed, std::int64_t now);
  /// Returns the next faster speed of kSpeeds, or the present speed if there is none.
  [[nodiscard]] double fasterSpeed() const;
  /// Returns the next slower speed of kSpeeds, or the present speed if there is none.
  [[nodiscard]] double slowerSpeed() const;
  /// Sets whether the clock starts from the beginning when it reaches the end.
  void setLooping(bool looping) { is_looping_ = looping; }
  [[nodiscard]] bool isLooping() const { return is_looping_; }

  /// Jumps to `position`, limited to the recording. A running clock continues from there.
  void seek(std::int64_t position, std::int64_t now);
  [[nodiscard]] std::int64_t position(std::int64_t now) const;
  /// Call this regularly. At the end of the recording, it stops the clock or sets it to the start.
  Turn update(std::int64_t now);

 private:
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::int64_t position_ = 0;  // the position at the time began_
  std::int64_t began_ = 0;
  double speed_ = 1.0;
  bool is_playing_ = false;
  bool is_looping_ = false;
};

}  // namespace tendon::gui
