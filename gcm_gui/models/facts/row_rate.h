#pragma once

#include <gcm_gui/session/signal_source.h>

#include <cstdint>

namespace tendon::gui {

/// How many rows of one column come in a second, by the times they were written; measured over a
/// second at least. O(1).
class RowRate {
 public:
  /// Its newest row. One of a new start of the source begins anew.
  void hear(const ColumnValues& values);
  /// 0 while it is not known.
  [[nodiscard]] double hz() const { return hz_; }

 private:
  // At the beginning of what is measured.
  std::uint64_t rows_ = 0;
  std::int64_t time_ = 0;
  double hz_ = 0;
};

}  // namespace tendon::gui
