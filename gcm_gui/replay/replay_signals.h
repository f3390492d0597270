#pragma once

#include <gcm_gui/replay/replay_reader.h>
#include <gcm_gui/session/column_signals.h>

#include <QStringList>
#include <map>
#include <memory>
#include <string>

namespace tendon::gui {

/// The rows of a recording as data for plots and tables. When a signal is subscribed, its rows up
/// to the shown moment are delivered at once.
class ReplaySignals final : public ColumnSignals {
  Q_OBJECT

 public:
  using ColumnSignals::ColumnSignals;

  void retry(const QString& /*column*/) override {}

  /// The used columns, with new feeds for a jump.
  [[nodiscard]] WantedColumns beginJump();
  /// Ends the jump: the new feeds replace the old ones, and all delivered samples are outdated.
  void endJump();
  /// Delivers the rows that have arrived.
  void deliver() { deliverRows(); }
  /// Delivers the newest values.
  void deliverValues() { deliverNewest(); }
  /// The subscribed signals.
  [[nodiscard]] QStringList subscribed() const;

 Q_SIGNALS:
  /// A signal was subscribed, so its earlier rows are needed.
  void pastWanted();
  /// The newest row of a column is needed.
  void columnWanted(const std::string& path, const std::shared_ptr<tendon::gui::ColumnFeed>& feed);

 private:
  bool begin(const QString& column, const std::shared_ptr<ColumnFeed>& feed) override;
  void onSubscribed() override { Q_EMIT pastWanted(); }

  std::map<QString, std::shared_ptr<ColumnFeed>> next_;  // by column, while there is a jump
};

}  // namespace tendon::gui
