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

}  // namespace tendon
