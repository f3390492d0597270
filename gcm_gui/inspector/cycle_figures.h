#pragma once

#include <gcm_gui/session/signal_source.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// The timing of a task. It comes from two columns that every task records in its own state table:
/// `CycleSummary` describes the last whole second, `Cycle` the last cycle.
class CycleFigures : public QObject {
  Q_OBJECT

 public:
  /// All values are in s. The values describe a whole second: a single period would mislead,
  /// because the period after a late cycle is short.
  struct LastSecond {
    double period = 0;   ///< mean
    double late = 0;     ///< the median lateness
    double later = 0;    ///< the 99th percentile of the lateness
    double latest = 0;   ///< the maximum lateness
    double compute = 0;  ///< mean
    double longest = 0;  ///< the longest period
    double most_computed = 0;
  };

  explicit CycleFigures(SignalSource& source, QObject* parent = nullptr);

  /// Sets the component by its path. If the path is empty or the component does not have these
  /// columns, there are no figures.
  void show(const QString& component);

  /// Empty until the values of a whole second have arrived.
  [[nodiscard]] const std::optional<LastSecond>& lastSecond() const { return last_second_; }
  /// The number of cycles that were skipped since the start because an earlier cycle took too long.
  /// Empty until a row has arrived.
  [[nodiscard]] std::optional<std::uint64_t> skipped() const { return skipped_; }

 private:
  void onValues(const QString& column, const ColumnValues& values);
  [[nodiscard]] QString cycleColumn() const;
  [[nodiscard]] QString summaryColumn() const;

  SignalSource& source_;
  QString component_;
  std::optional<LastSecond> last_second_;
  std::optional<std::uint64_t> skipped_;
};

}  // namespace tendon::gui
