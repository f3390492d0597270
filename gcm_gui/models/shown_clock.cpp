#include <gcm_gui/models/shown_clock.h>

#include <gcm_gui/plot/series/shown_time.h>

#include <chrono>

namespace tendon::gui {

const Clock& ShownClock() {
  class ShownTimeClock final : public Clock {
   public:
    [[nodiscard]] SteadyTime Now() const noexcept override {
      return SteadyTime(std::chrono::nanoseconds(ShownTime()));
    }
  };
  static const ShownTimeClock clock;
  return clock;
}

}  // namespace tendon::gui
