#include <gcm_gui/replay/playback_clock.h>

#include <algorithm>
#include <cmath>

namespace tendon::gui {

void PlaybackClock::play(std::int64_t now) {
  if (is_playing_) return;
  seek(position_ >= last_ ? first_ : position_, now);
  is_playing_ = true;
}

void PlaybackClock::pause(std::int64_t now) {
  seek(position(now), now);
  is_playing_ = false;
}

void PlaybackClock::setSpeed(double speed, std::int64_t now) {
  seek(position(now), now);
  speed_ = std::clamp(speed, kSlowest, kFastest);
}

double PlaybackClock::fasterSpeed() const {
  const auto* next = std::upper_bound(kSpeeds.begin(), kSpeeds.end(), speed_);
  return next == kSpeeds.end() ? speed_ : *next;
}

double PlaybackClock::slowerSpeed() const {
  const auto* next = std::lower_bound(kSpeeds.begin(), kSpeeds.end(), speed_);
  return next == kSpeeds.begin() ? speed_ : *(next - 1);
}

void PlaybackClock::seek(std::int64_t position, std::int64_t now) {
  position_ = std::clamp(position, first_, last_);
  began_ = now;
}

std::int64_t PlaybackClock::position(std::int64_t now) const {
  if (!is_playing_) return position_;
  const double passed = static_cast<double>(now - began_) * speed_;
  // Compared as numbers, because a long time would overflow.
  if (passed >= static_cast<double>(last_ - position_)) return last_;
  return position_ + std::llround(passed);
}

PlaybackClock::Turn PlaybackClock::update(std::int64_t now) {
  if (!is_playing_ || position(now) < last_) return Turn::kNone;
  if (is_looping_) {
    seek(first_, now);
    return Turn::kBeganAgain;
  }
  pause(now);
  return Turn::kEnded;
}

}  // namespace tendon::gui
