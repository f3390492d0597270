#include <gcm_gui/plot/series/shown_time.h>

#include <chrono>
#include <optional>

namespace tendon::gui {
namespace {

std::optional<ShownMoment>& Moment() {
  static std::optional<ShownMoment> moment;
  return moment;
}

template <typename Clock>
std::int64_t NowOn() {
  return std::chrono::nanoseconds(Clock::now().time_since_epoch()).count();
}

}  // namespace

std::int64_t ShownTime() {
  return Moment() ? Moment()->steady_ns : NowOn<std::chrono::steady_clock>();
}

std::int64_t ShownWallTime() {
  return Moment() ? Moment()->wall_ns : NowOn<std::chrono::system_clock>();
}

std::int64_t WallOffset() {
  if (Moment()) return Moment()->wall_ns - Moment()->steady_ns;
  static const std::int64_t offset =
      NowOn<std::chrono::system_clock>() - NowOn<std::chrono::steady_clock>();
  return offset;
}

QString ShownRecording() { return Moment() ? Moment()->recording : QString(); }

void ShowMoment(const ShownMoment& moment) { Moment() = moment; }

void ShowPresent() { Moment().reset(); }

bool IsMomentShown() { return Moment().has_value(); }

}  // namespace tendon::gui
