#include <gcm_gui/plot/canvas/late_samples.h>

#include <algorithm>

namespace tendon::gui {
namespace {

constexpr std::uint64_t kKnown = 16;  // earlier samples from which the period is determined
constexpr std::uint64_t kMin = 4;
constexpr double kLate = 0.5;  // periods

}  // namespace

bool IsLate(const SampleRing& samples, std::uint64_t index) {
  if (index < samples.firstIndex() + kMin + 1) return false;
  const std::uint64_t before = index - 1;
  const std::uint64_t first = std::max(samples.firstIndex(), before - std::min(before, kKnown));
  const bool is_unbroken =
      samples.tick(first) < samples.tick(before) && samples.tick(before) < samples.tick(index);
  if (!is_unbroken) return false;
  const auto span_ns = static_cast<double>(samples.time(before) - samples.time(first));
  const double period_ns =
      span_ns / static_cast<double>(samples.tick(before) - samples.tick(first));
  const auto ticks = static_cast<double>(samples.tick(index) - samples.tick(before));
  const auto waited_ns = static_cast<double>(samples.time(index) - samples.time(before));
  return waited_ns > period_ns * (ticks + kLate);
}

}  // namespace tendon::gui
