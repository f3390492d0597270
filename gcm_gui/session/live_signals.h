#pragma once

#include <gcm_gui/session/signal_source.h>
#include <tendon/base/path.h>
#include <tendon/process/telemetry_client.h>

#include <QHash>
#include <QSet>
#include <QString>
#include <QTimer>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>

namespace tendon::gui {

class ColumnFeed;

/// Live data over the network: one subscription a column, shared by all who look at it, and a
/// second one until the row that was there before it has come; kept for a moment after the last has
/// looked away. Rows are handed out 30 times a second, newest values 10 times.
class LiveSignals : public SignalSource {
  Q_OBJECT

 public:
  /// `telemetry` must outlive it.
  explicit LiveSignals(TelemetryClient& telemetry, QObject* parent = nullptr);
  ~LiveSignals() override;

  void subscribe(const QString& signal) override;
  void release(const QString& signal) override;
  void watch(const QObject* owner, const QSet<QString>& columns) override;
  [[nodiscard]] RowLosses losses(const QString& signal) const override;
  void retry(const QString& column) override;

  /// How many columns are subscribed to now.
  [[nodiscard]] std::size_t columnCount() const { return columns_.size(); }

  /// Hands out what has come; the timers call it.
  void drain();
  void drainValues();
  /// Ends the subscriptions that nobody has used for a while.
  void dropUnused();

 private:
  struct Column {
    std::shared_ptr<ColumnFeed> feed;
    TableSubscription table;
    TelemetryClient::Id id = 0;
    std::optional<TelemetryClient::Id> standing;  // until a row is there
    std::map<QString, int> users;                 // of each signal
    QSet<const QObject*> watchers;
    int idle_sweeps = 0;

    [[nodiscard]] bool used() const { return !users.empty() || !watchers.isEmpty(); }
  };

  /// Null for what is no path of a column.
  Column* open(const QString& column);
  /// Asks for the row that was there before, where somebody looks at the column and none has come;
  /// also after the link was cut, when it is another one.
  void seekStandingRow(Column& column);
  void endStanding(Column& column);
  void drainSignal(Column& column, const QString& signal);
  void end(const Column& column);

  TelemetryClient& telemetry_;
  std::map<QString, Column> columns_;
  QSet<const QObject*> known_owners_;
  QTimer rows_timer_;
  QTimer values_timer_;
  QTimer sweep_timer_;
};

/// "robot/arm/state.Joints" of "robot/arm/state.Joints.position[0]"; empty when it is no such path.
[[nodiscard]] QString ColumnPathOf(const QString& signal);

}  // namespace tendon::gui
