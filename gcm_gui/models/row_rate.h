#pragma once

#include <gcm_gui/session/signal_source.h>

#include <cstdint>

namespace tendon::gui {

/// The number of rows of one column per second, from their write times over at least one second.
/// O(1).
class RowRate {
 public:
  /// Takes the newest row. A restart of the source restarts the measurement.
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
