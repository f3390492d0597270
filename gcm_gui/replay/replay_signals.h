#pragma once

#include <gcm_gui/replay/replay_reader.h>
#include <gcm_gui/session/signal_source.h>

#include <QSet>
#include <map>
#include <memory>
#include <string>

namespace tendon::gui {

/// The rows of a recording as data for plots and tables. Rows up to the shown moment are there at
/// once, as soon as a signal is subscribed.
class ReplaySignals final : public SignalSource {
  Q_OBJECT

 public:
  using SignalSource::SignalSource;

  void subscribe(const QString& signal) override;
  void release(const QString& signal) override;
  void watch(const QObject* owner, const QSet<QString>& columns) override;
  [[nodiscard]] RowLosses losses(const QString& signal) const override;
  void retry(const QString& /*column*/) override {}

  /// The used columns, with new feeds for a jump.
  [[nodiscard]] WantedColumns beginJump();
  /// The jump has ended: the new feeds replace the old ones, and what was delivered is out of date.
  void endJump();
  /// Delivers the rows that have arrived.
  void deliver();
  /// Delivers the newest values.
  void deliverValues();

 Q_SIGNALS:
  /// A signal was subscribed, so its past is needed.
  void pastWanted();
  /// The newest row of a column is needed.
  void columnWanted(const std::string& path, const std::shared_ptr<tendon::gui::ColumnFeed>& feed);

 private:
  struct Column {
    std::shared_ptr<ColumnFeed> feed;
    std::shared_ptr<ColumnFeed> next;                      // while there is a jump
    std::map<QString, std::pair<int, std::string>> users;  // by signal: count, field
    QSet<const QObject*> watchers;
  };

  Column* open(const QString& column);

  std::map<QString, Column> columns_;
  QSet<const QObject*> known_owners_;
};

}  // namespace tendon::gui
