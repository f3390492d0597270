#pragma once

#include <gcm_gui/session/signal_source.h>

#include <cstdint>

namespace tendon::gui {

/// Measures the number of rows of one column per second, from their write times over at least one
/// second. O(1).
class RowRate {
 public:
  /// Called with the newest row. If the source was restarted, the measurement starts again.
  void onValues(const ColumnValues& values);
  /// 0 while unknown.
  [[nodiscard]] double hz() const { return hz_; }

 private:
  // The row count and time at the start of the measurement.
  std::uint64_t rows_ = 0;
  std::int64_t time_ = 0;
  double hz_ = 0;
};

}  // namespace tendon::gui
