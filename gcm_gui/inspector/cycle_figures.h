#pragma once

#include <gcm_gui/session/signal_source.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <optional>

namespace tendon::gui {

/// How well a task keeps its time, from the two columns that every task keeps in its own state
/// table: `CycleSummary`, about the last whole second, and `Cycle`, about the last cycle.
class CycleFigures : public QObject {
  Q_OBJECT

 public:
  /// All in s. One cycle alone says nothing: after a late one the next comes early.
  struct LastSecond {
    double period = 0;   ///< mean
    double late = 0;     ///< half of the cycles began no later than that
    double later = 0;    ///< 99 %
    double latest = 0;   ///< all of them
    double compute = 0;  ///< mean
    double longest = 0;  ///< of all periods
    double most_computed = 0;
  };

  explicit CycleFigures(SignalSource& source, QObject* parent = nullptr);

  /// `component` by path; empty for none, and for one without the columns.
  void show(const QString& component);

  /// Nothing before a second is over.
  [[nodiscard]] const std::optional<LastSecond>& lastSecond() const { return last_second_; }
  /// Cycles left out since the start because one before took too long; nothing before a row has
  /// come.
  [[nodiscard]] std::optional<std::uint64_t> skipped() const { return skipped_; }

 private:
  void hearValues(const QString& column, const ColumnValues& values);
  [[nodiscard]] QString cycleColumn() const;
  [[nodiscard]] QString summaryColumn() const;

  SignalSource& source_;
  QString component_;
  std::optional<LastSecond> last_second_;
  std::optional<std::uint64_t> skipped_;
};

}  // namespace tendon::gui
