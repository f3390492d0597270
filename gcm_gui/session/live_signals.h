#pragma once

#include <gcm_gui/session/column_signals.h>
#include <tendon/process/telemetry_client.h>

#include <QString>
#include <QTimer>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>

namespace tendon::gui {

/// Live data over the network. All users of a column share one subscription, which ends some time
/// after its last user has left. A second subscription fetches the row that existed before, and
/// ends when this row has arrived. Rows are delivered 30 times a second, newest values 10 times a
/// second.
class LiveSignals : public ColumnSignals {
  Q_OBJECT

 public:
  /// `telemetry` must outlive this object.
  explicit LiveSignals(TelemetryClient& telemetry, QObject* parent = nullptr);
  ~LiveSignals() override;

  void retry(const QString& column) override;

  /// The number of subscribed columns.
  [[nodiscard]] std::size_t columnCount() const { return columns().size(); }

  /// Delivers the rows that have arrived; called by a timer.
  void drain() { deliverRows(); }
  void drainValues();
  /// Ends the subscriptions that have not been used for a while.
  void dropUnused();

 private:
  struct Subscription {
    TableSubscription table;
    TelemetryClient::Id id = 0;
    std::optional<TelemetryClient::Id> initial;  // for the initial row; set until a row arrives
    int idle_sweeps = 0;
  };

  /// Subscribes to a column. Returns false if `column` is not the path of a column.
  bool begin(const QString& column, const std::shared_ptr<ColumnFeed>& feed) override;
  /// Requests the last row that was written before the subscription, if the column has watchers but
  /// no row yet. After a lost link, requests this row again, because there may be a newer one.
  void onWatched(const QString& column) override;
  void endInitialRow(Subscription& subscription);
  void end(const Subscription& subscription);

  TelemetryClient& telemetry_;
  std::map<QString, Subscription> subscriptions_;  // by column
  QTimer rows_timer_;
  QTimer values_timer_;
  QTimer sweep_timer_;
};

}  // namespace tendon::gui
