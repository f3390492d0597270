#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace tendon::gui {

enum class Cursor { kA, kB };
inline constexpr std::array kCursors{Cursor::kA, Cursor::kB};

/// Two times that the user has marked in a plot, to measure the distance between them. They are
/// times of the source, so they stay at the same samples while the window moves.
class Cursors {
 public:
  void set(Cursor cursor, std::int64_t time_ns) { at(cursor) = time_ns; }
  void clear() { times_ = {}; }

  [[nodiscard]] std::optional<std::int64_t> time(Cursor cursor) const {
    return times_[static_cast<std::size_t>(cursor)];
  }
  [[nodiscard]] bool any() const { return time(Cursor::kA) || time(Cursor::kB); }
  [[nodiscard]] bool both() const { return time(Cursor::kA) && time(Cursor::kB); }
  /// Returns the time from A to B in s; 0 unless both cursors exist.
  [[nodiscard]] double span() const {
    return both() ? static_cast<double>(*time(Cursor::kB) - *time(Cursor::kA)) / 1e9 : 0;
  }

 private:
  [[nodiscard]] std::optional<std::int64_t>& at(Cursor cursor) {
    return times_[static_cast<std::size_t>(cursor)];
  }

  std::array<std::optional<std::int64_t>, 2> times_;
};

}  // namespace tendon::gui
