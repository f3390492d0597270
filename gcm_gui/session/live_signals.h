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

/// Live data over the network. All users of a column share one subscription, which ends some time
/// after its last user has left. A second subscription fetches the row that existed before, and
/// ends when this row has arrived. Rows are delivered 30 times a second, newest values 10 times a
/// second.
class LiveSignals : public SignalSource {
  Q_OBJECT

 public:
  /// `telemetry` must outlive this object.
  explicit LiveSignals(TelemetryClient& telemetry, QObject* parent = nullptr);
  ~LiveSignals() override;

  void subscribe(const QString& signal) override;
  void release(const QString& signal) override;
  void watch(const QObject* owner, const QSet<QString>& columns) override;
  [[nodiscard]] RowLosses losses(const QString& signal) const override;
  void retry(const QString& column) override;

  /// The number of subscribed columns.
  [[nodiscard]] std::size_t columnCount() const { return columns_.size(); }

  /// Delivers the rows that have arrived; called by a timer.
  void drain();
  void drainValues();
  /// Ends the subscriptions that have not been used for a while.
  void dropUnused();

 private:
  struct User {
    int count = 0;      // number of subscriptions to the signal
    std::string field;  // the part of the signal after the column: ".position[0]"
  };

  struct Column {
    std::shared_ptr<ColumnFeed> feed;
    TableSubscription table;
    TelemetryClient::Id id = 0;
    std::optional<TelemetryClient::Id> initial;  // for the initial row; set until a row arrives
    std::map<QString, User> users;               // by signal
    QSet<const QObject*> watchers;
    int idle_sweeps = 0;

    [[nodiscard]] bool used() const { return !users.empty() || !watchers.isEmpty(); }
  };

  /// Subscribes to a column, unless it is subscribed already. Returns null if `column` is not the
  /// path of a column.
  Column* open(const QString& column);
  /// Requests the last row that was written before the subscription, if the column has watchers but
  /// no row yet. After a lost link, requests this row again, because there may be a newer one.
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

/// Returns the column of a signal: "robot/arm/state.Joints" for
/// "robot/arm/state.Joints.position[0]". Empty for other paths.
[[nodiscard]] QString ColumnPathOf(const QString& signal);

}  // namespace tendon::gui
