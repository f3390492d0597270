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

/// Live data over the network. All users of a column share one subscription. A second subscription
/// fetches the row that existed before, and ends when that row has arrived. The first one ends some
/// time after its last user. Delivers rows 30 times a second, newest values 10 times.
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

  /// The number of subscribed columns.
  [[nodiscard]] std::size_t columnCount() const { return columns_.size(); }

  /// Delivers new data; called by the timers.
  void drain();
  void drainValues();
  /// Ends subscriptions that have been unused for a while.
  void dropUnused();

 private:
  struct User {
    int count = 0;      // of subscriptions to the signal
    std::string field;  // the part of the signal after the column: ".position[0]"
  };

  struct Column {
    std::shared_ptr<ColumnFeed> feed;
    TableSubscription table;
    TelemetryClient::Id id = 0;
    std::optional<TelemetryClient::Id> initial;  // of the initial row, set until a row has arrived
    std::map<QString, User> users;               // by signal
    QSet<const QObject*> watchers;
    int idle_sweeps = 0;

    [[nodiscard]] bool used() const { return !users.empty() || !watchers.isEmpty(); }
  };

  /// Null if `column` is not the path of a column.
  Column* open(const QString& column);
  /// Requests the row that existed before the subscription, if the column has users and no row yet;
  /// does so again after a lost link, because there may be another row.
  void requestInitialRow(Column& column);
  void endInitialRow(Column& column);
  void end(const Column& column);

  TelemetryClient& telemetry_;
  std::map<QString, Column> columns_;
  QSet<const QObject*> known_owners_;
  QTimer rows_timer_;
  QTimer values_timer_;
  QTimer sweep_timer_;
};

/// "robot/arm/state.Joints" of "robot/arm/state.Joints.position[0]"; empty for other paths.
[[nodiscard]] QString ColumnPathOf(const QString& signal);

}  // namespace tendon::gui
