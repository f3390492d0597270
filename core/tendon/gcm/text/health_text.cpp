#include <tendon/gcm/text/health_text.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace tendon {
namespace {

constexpr const char* kUnknown = "-";

std::string OneDigit(double value) {
  std::array<char, 320> text{};
  const auto end = std::to_chars(text.begin(), text.end(), value, std::chars_format::fixed, 1).ptr;
  return {text.data(), end};
}

std::string Milliseconds(std::chrono::nanoseconds time) {
  constexpr double kMillisecond = 1e6;
  return OneDigit(static_cast<double>(time.count()) / kMillisecond) + " ms";
}

}  // namespace

const message::ProcessHealth* LastHealth(const message::SystemHealth& health,
                                         const ProcessDescription& process) {
  const auto found =
      std::ranges::find(health.processes, process.name, &message::ProcessHealth::process);
  const bool is_known = found != health.processes.end() && found->instance == process.instance;
  return is_known ? &*found : nullptr;
}

const message::ProcessHealth* FindHealth(const message::SystemHealth& health,
                                         const ProcessDescription& process) {
  if (process.state != ProcessState::kAlive) return nullptr;
  const auto* const last = LastHealth(health, process);
  return last != nullptr && last->age <= kFreshHealth ? last : nullptr;
}

std::string CpuText(const message::ProcessHealth* health) {
  constexpr double kPercent = 100.0;
  return health == nullptr || health->cpu < 0.0 ? kUnknown
                                                : OneDigit(health->cpu * kPercent) + " %";
}

std::string MemoryText(const message::ProcessHealth* health) {
  constexpr double kMiB = 1024.0 * 1024.0;
  if (health == nullptr || health->memory == 0) return kUnknown;
  return OneDigit(static_cast<double>(health->memory) / kMiB) + " MiB";
}

std::string ClockText(const message::ProcessHealth* health) {
  if (health == nullptr || health->clock_uncertainty < std::chrono::nanoseconds(0)) return kUnknown;
  return Milliseconds(health->clock_offset) + " off (+-" + Milliseconds(health->clock_uncertainty) +
         ")";
}

}  // namespace tendon
