#pragma once

#include <gcm_gui/models/row_rate.h>
#include <gcm_gui/models/shown_clock.h>
#include <tendon/base/clock.h>

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>
#include <chrono>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// Records when rows of columns arrive. A column without rows for kSilence is dropped if it is not
/// watched, because its subscription may have ended. GUI thread.
class ColumnArrivals {
 public:
  /// The maximum time without rows for a column that is not watched.
  static constexpr std::chrono::seconds kSilence{2};

  explicit ColumnArrivals(const Clock& clock = ShownClock()) : clock_(clock) {}

  void onValues(const QString& column, const ColumnValues& values);
  /// Sets the columns that certainly have a subscription. For other columns, missing rows do not
  /// count as an interruption.
  void setWatched(const QSet<QString>& columns) { watched_ = columns; }
  void forget(const QString& column) { all_.remove(column); }
  /// Drops the columns that are not watched and have had no rows for kSilence. Returns the
  /// remaining columns.
  QStringList dropSilent();

  /// Returns the number of rows per second; empty if it is unknown or if no more rows arrive.
  [[nodiscard]] std::optional<double> rate(const QString& column) const;
  /// Returns the last known rate in Hz, even if no more rows arrive; 0 if it is unknown.
  [[nodiscard]] double usualRate(const QString& column) const;
  /// Returns the time in ns since the newest row was written; empty if unknown.
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
