#pragma once

#include <gcm_gui/session/column_feed.h>
#include <gcm_gui/session/signal_source.h>

#include <QSet>
#include <QString>
#include <map>
#include <memory>
#include <string>

namespace tendon::gui {

/// The common part of all sources of signals. It stores the users of each column, and has one feed
/// per column, which all users share. Derived classes fill the feeds, and decide when rows are
/// delivered.
class ColumnSignals : public SignalSource {
  Q_OBJECT

 public:
  using SignalSource::SignalSource;

  void subscribe(const QString& signal) final;
  void release(const QString& signal) final;
  void watch(const QObject* owner, const QSet<QString>& columns) final;
  [[nodiscard]] RowLosses losses(const QString& signal) const final;

 protected:
  struct User {
    int count = 0;      // number of subscriptions to the signal
    std::string field;  // the part of the signal after the column: ".position[0]"
  };

  struct Column {
    std::shared_ptr<ColumnFeed> feed;
    std::map<QString, User> users;  // by signal
    QSet<const QObject*> watchers;

    [[nodiscard]] bool isUsed() const { return !users.empty() || !watchers.isEmpty(); }
  };

  [[nodiscard]] std::map<QString, Column>& columns() { return columns_; }
  [[nodiscard]] const std::map<QString, Column>& columns() const { return columns_; }

  /// Delivers all rows in the feeds.
  void deliverRows();
  /// Delivers the newest values in the feeds of watched columns.
  void deliverNewest();

 private:
  /// Begins to fill the feed of a column. Returns false if `column` cannot be the path of a column.
  virtual bool begin(const QString& column, const std::shared_ptr<ColumnFeed>& feed) = 0;
  /// Called after a signal was subscribed for the first time.
  virtual void onSubscribed() {}
  /// Called after a column got a watcher.
  virtual void onWatched(const QString& /*column*/) {}

  Column* open(const QString& path);

  std::map<QString, Column> columns_;
  QSet<const QObject*> known_owners_;
};

/// Returns the column of a signal: "robot/arm/state.Joints" for
/// "robot/arm/state.Joints.position[0]". Empty for other paths.
[[nodiscard]] QString ColumnPathOf(const QString& signal);

}  // namespace tendon::gui
