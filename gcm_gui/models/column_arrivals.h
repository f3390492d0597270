#pragma once

#include <gcm_gui/models/row_rate.h>
#include <tendon/base/clock.h>

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>
#include <chrono>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// Tracks the arrival of rows of columns. Drops a silent column that is not watched, because its
/// subscription may have ended. GUI thread.
class ColumnArrivals {
 public:
  /// How long a column that is not watched may be silent.
  static constexpr std::chrono::seconds kSilence{2};

  explicit ColumnArrivals(const Clock& clock = SteadyClock()) : clock_(clock) {}

  void onValues(const QString& column, const ColumnValues& values);
  /// Sets the columns with a certain subscription; only their silence counts as an interruption.
  void setWatched(const QSet<QString>& columns) { watched_ = columns; }
  void forget(const QString& column) { all_.remove(column); }
  /// Forgets silent columns that are not watched; returns the remaining ones.
  QStringList dropSilent();

  /// Rows per second; empty if unknown or if rows have stopped.
  [[nodiscard]] std::optional<double> rate(const QString& column) const;
  /// The last known rate in Hz, even if rows have stopped; 0 if unknown.
  [[nodiscard]] double usualRate(const QString& column) const;
  /// The time in ns since the newest row was written.
  [[nodiscard]] std::optional<std::int64_t> age(const QString& column) const;

 private:
  struct Arrival {
    RowRate rate;
    std::int64_t written = 0;  // ns on the steady clock; 0 before the first row
    SteadyTime time;
  };
  [[nodiscard]] bool isLeft(const QString& column, const Arrival& arrival) const;

  const Clock& clock_;
  QHash<QString, Arrival> all_;
  QSet<QString> watched_;
};

}  // namespace tendon::gui
