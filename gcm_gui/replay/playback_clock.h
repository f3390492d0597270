#pragma once

#include <array>
#include <cstdint>

namespace tendon::gui {

/// The time of a recording while it is played: it runs with a speed, stops, and jumps. All times
/// are in ns; those of the recording since 1970, `now` on any clock that never goes back.
class PlaybackClock {
 public:
  /// The speeds that the user can choose, sorted.
  static constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0};
  static constexpr double kSlowest = kSpeeds.front();
  static constexpr double kFastest = kSpeeds.back();
  /// What has happened since the last update.
  enum class Turn {
    kNone,
    kEnded,       ///< the end was reached: the clock stands
    kBeganAgain,  ///< the end was reached: the clock runs from the begin again
  };

  PlaybackClock() = default;
  /// Stands at the begin. `last` is not before `first`.
  PlaybackClock(std::int64_t first, std::int64_t last)
      : first_(first), last_(last), position_(first) {}

  [[nodiscard]] std::int64_t first() const { return first_; }
  [[nodiscard]] std::int64_t last() const { return last_; }
  [[nodiscard]] std::int64_t length() const { return last_ - first_; }

  [[nodiscard]] bool isPlaying() const { return is_playing_; }
  /// At the end, begins again.
  void play(std::int64_t now);
  void pause(std::int64_t now);
  [[nodiscard]] double speed() const { return speed_; }
  /// Limited to kSlowest and kFastest; the position stays.
  void setSpeed(double speed, std::int64_t now);
  /// The next of kSpeeds above or below the speed; the speed itself if there is none.
  [[nodiscard]] double fasterSpeed() const;
  [[nodiscard]] double slowerSpeed() const;
  /// Whether it begins again at the end.
  void setLooping(bool looping) { is_looping_ = looping; }
  [[nodiscard]] bool isLooping() const { return is_looping_; }

  /// Limited to the recording; goes on from there.
  void seek(std::int64_t position, std::int64_t now);
  [[nodiscard]] std::int64_t position(std::int64_t now) const;
  /// Ends the run or begins it again at the end of the recording.
  Turn update(std::int64_t now);

 private:
  std::int64_t first_ = 0;
  std::int64_t last_ = 0;
  std::int64_t position_ = 0;  // at began_
  std::int64_t began_ = 0;
  double speed_ = 1.0;
  bool is_playing_ = false;
  bool is_looping_ = false;
};

}  // namespace tendon::gui
