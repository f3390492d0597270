#pragma once

#include <gcm_gui/session/signal_source.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// The timing of a task, from two columns that every task records in its own state table:
/// `CycleSummary`, about the last whole second, and `Cycle`, about the last cycle.
class CycleFigures : public QObject {
  Q_OBJECT

 public:
  /// All in s. Over a whole second, because the period after a late cycle is short.
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

  /// `component` is a path; empty, or a component without these columns, shows nothing.
  void show(const QString& component);

  /// Empty until a whole second was received.
  [[nodiscard]] const std::optional<LastSecond>& lastSecond() const { return last_second_; }
  /// Cycles skipped since the start because an earlier one took too long; empty until a row was
  /// received.
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
