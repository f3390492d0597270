#pragma once

#include <gcm_gui/reports/system_reports.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace tendon::gui {

/// What is wrong with a connection that stands, in words; empty where nothing is. `before` are its
/// counts when it was looked at last.
[[nodiscard]] QString HealthWarning(const ConnectionCounts& now,
                                    const std::optional<ConnectionCounts>& before);

/// How the connections do that can be seen, while somebody looks. However many they are, it asks
/// about kMostAtOnce of them a second, in turn, and about no further one while so many have not
/// answered. The one that is pointed at comes first, each second.
class EdgeHealth : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMostAtOnce = 8;
  /// The required interfaces of the connections that work and can be seen now.
  using Seen = std::function<std::vector<InterfaceName>()>;

  EdgeHealth(SystemReports& reports, Seen seen, QObject* parent = nullptr);

 public Q_SLOTS:
  /// Nothing is asked while nobody does.
  void setLooking(bool looking);
  /// Asks about the next ones.
  void look();
  /// Asks about this one now, and again with each look; empty: about none in particular. What is
  /// known of it is told at once.
  void point(const QString& required);

 Q_SIGNALS:
  /// Without a warning nothing is wrong.
  void found(const tendon::InterfaceName& required, const QString& warning);
  /// Of the one that is pointed at: what it has counted, or why that is not known.
  void counted(const tendon::InterfaceName& required, const QStringList& lines);

 private:
  void ask(const InterfaceName& required);
  void hear(const InterfaceName& required, const Result<ConnectionCounts>& counts);

  SystemReports& reports_;
  Seen seen_;
  QTimer second_;
  InterfaceName last_;             // the one that was asked about last, in turn
  std::set<InterfaceName> asked_;  // and not answered yet
  std::optional<InterfaceName> pointed_;
  std::map<InterfaceName, ConnectionCounts> known_;
};

}  // namespace tendon::gui
