#include <tendon/recording/mcap/log_time_text.h>

#include <tendon/gcm/text.h>

#include <array>
#include <cstdio>
#include <limits>

namespace tendon::mcap {

std::string LogTimeText(Timestamp time) {
  constexpr Timestamp kYear2000 = 946'684'800'000'000'000;
  constexpr Timestamp kMillisecond = 1'000'000;
  if (time >= kYear2000 && time <= std::numeric_limits<std::int64_t>::max()) {
    return FineWallTimeText(static_cast<std::int64_t>(time));
  }
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%llu.%03llu s",
                static_cast<unsigned long long>(time / (1000 * kMillisecond)),
                static_cast<unsigned long long>(time / kMillisecond % 1000));
  return text.data();
}

}  // namespace tendon::mcap
