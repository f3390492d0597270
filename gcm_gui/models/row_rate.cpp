#include <gcm_gui/models/row_rate.h>

namespace tendon::gui {

void RowRate::onValues(const ColumnValues& values) {
  constexpr double kMinTime = 1;  // s
  const double passed = 1e-9 * static_cast<double>(values.time - time_);
  const bool begins = time_ == 0 || values.rows < rows_ || passed < 0;
  if (!begins && passed < kMinTime) return;
  hz_ = begins ? 0 : static_cast<double>(values.rows - rows_) / passed;
  rows_ = values.rows;
  time_ = values.time;
}

}  // namespace tendon::gui
