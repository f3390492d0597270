#include <tendon/gcm/text/wall_time.h>

#include <array>
#include <chrono>
#include <ctime>

namespace tendon {

std::int64_t WallTime() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

std::string WallTimeText(std::int64_t nanoseconds) {
  const std::chrono::nanoseconds since(nanoseconds);
  const std::time_t seconds = std::chrono::duration_cast<std::chrono::seconds>(since).count();
  std::tm parts{};
  localtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%d %H:%M:%S", &parts);
  return {text.data(), length};
}

std::string FineWallTimeText(std::int64_t nanoseconds) {
  constexpr std::int64_t kMillisecond = 1'000'000;
  const std::int64_t below_second =
      (nanoseconds / kMillisecond % 1000 + 1000) % 1000;  // also before 1970
  std::string milliseconds = std::to_string(1000 + below_second);
  milliseconds.front() = '.';
  return WallTimeText(nanoseconds) + milliseconds;
}

}  // namespace tendon
