#pragma once

#include <gcm_gui/session/signal_source.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>

namespace tendon::gui {

/// How well a task keeps its time, from the column `Cycle` of its own state table: the newest
/// period and overruns, and the spread of its lateness over the last rows.
class CycleFigures : public QObject {
  Q_OBJECT

 public:
  explicit CycleFigures(SignalSource& source, QObject* parent = nullptr);

  /// `component` by path; empty for none, and for one without the column.
  void show(const QString& component);

  [[nodiscard]] bool known() const { return period_.has_value(); }
  [[nodiscard]] double period() const { return period_.value_or(0); }  ///< s
  [[nodiscard]] double compute() const { return compute_; }            ///< s
  [[nodiscard]] std::uint64_t overruns() const { return overruns_; }
  /// The lateness that this part (0 to 1) of the last rows did not exceed, in s; nothing before a
  /// row has come.
  [[nodiscard]] std::optional<double> lateness(double part) const;

 Q_SIGNALS:
  void changed();

 private:
  static constexpr std::size_t kRows = 1000;

  void hearValues(const QString& column, const ColumnValues& values);
  void hearSamples(const QString& signal, std::span<const Sample> samples);
  [[nodiscard]] QString column() const;
  [[nodiscard]] QString latenessSignal() const;

  SignalSource& source_;
  QString component_;
  std::optional<double> period_;
  double compute_ = 0;
  std::uint64_t overruns_ = 0;
  std::deque<double> lateness_;
};

}  // namespace tendon::gui
