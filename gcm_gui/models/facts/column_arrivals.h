#pragma once

#include <gcm_gui/models/facts/row_rate.h>
#include <tendon/base/clock.h>

#include <QHash>
#include <QSet>
#include <QString>
#include <QStringList>
#include <chrono>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// How the rows of columns arrive, of those that somebody looks at: who else looks is not known
/// here, so one that is not watched and stays silent is no longer known. GUI thread.
class ColumnArrivals {
 public:
  /// So long what is not watched may be silent.
  static constexpr std::chrono::seconds kSilence{2};

  explicit ColumnArrivals(const Clock& clock = SteadyClock()) : clock_(clock) {}

  void hear(const QString& column, const ColumnValues& values);
  /// From now on these are listened to for certain: their silence means something.
  void setWatched(const QSet<QString>& columns) { watched_ = columns; }
  void forget(const QString& column) { all_.remove(column); }
  /// Forgets what is silent and not watched; the columns that are left.
  QStringList dropSilent();

  /// Rows a second, Hz; nothing where it is not known, or where they no longer come.
  [[nodiscard]] std::optional<double> rate(const QString& column) const;
  /// The same, also where they no longer come; 0 where it is not known.
  [[nodiscard]] double usualRate(const QString& column) const;
  /// Since the newest row was written, ns.
  [[nodiscard]] std::optional<std::int64_t> age(const QString& column) const;

 private:
  struct Arrival {
    RowRate rate;
    std::int64_t written = 0;  // ns on the steady clock; 0 before a row
    SteadyTime heard;
  };
  [[nodiscard]] bool isLeft(const QString& column, const Arrival& arrival) const;

  const Clock& clock_;
  QHash<QString, Arrival> all_;
  QSet<QString> watched_;
};

}  // namespace tendon::gui
