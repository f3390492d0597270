#pragma once

#include <QString>
#include <cstdint>
#include <limits>
#include <optional>

namespace tendon::gui {

/// The longest shift of a recording relative to the shown time, in both directions: 100 years in
/// ns.
inline constexpr std::int64_t kLongestShift = std::int64_t{36525} * 24 * 3600 * 1'000'000'000;

/// Returns a time that is moved by `by_ns`, limited to the range of the type.
[[nodiscard]] constexpr std::int64_t MovedTime(std::int64_t time_ns, std::int64_t by_ns) {
  using Limits = std::numeric_limits<std::int64_t>;
  if (by_ns > 0 && time_ns > Limits::max() - by_ns) return Limits::max();
  if (by_ns < 0 && time_ns < Limits::min() - by_ns) return Limits::min();
  return time_ns + by_ns;
}

/// Formats a shift with its sign: "−2 h 03 min 12.5 s". ShiftIn() converts the text back to the
/// same shift.
[[nodiscard]] QString ShiftText(std::int64_t shift_ns);
/// Likewise, rounded to milliseconds.
[[nodiscard]] QString RoundedShiftText(std::int64_t shift_ns);
/// Parses a shift: seconds such as "-12.5", or a text in the form of ShiftText(). Empty if the text
/// is neither, or if the shift is longer than kLongestShift.
[[nodiscard]] std::optional<std::int64_t> ShiftIn(const QString& text);

}  // namespace tendon::gui
