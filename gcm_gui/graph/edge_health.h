#pragma once

#include <gcm_gui/session/system_reports.h>

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

/// Returns the problems of a working connection in words; empty if there are none. `before`
/// contains the counts of the previous check.
[[nodiscard]] QString HealthWarning(const ConnectionCounts& now,
                                    const std::optional<ConnectionCounts>& before);

/// Polls the health of the visible connections while the graph is visible: about kMaxAtOnce
/// connections per second, one after another, with at most kMaxAtOnce unanswered requests. The
/// connection under the pointer is polled first, every second.
class EdgeHealth : public QObject {
  Q_OBJECT

 public:
  static constexpr std::size_t kMaxAtOnce = 8;
  /// Returns the required interfaces of the working connections that are visible now.
  using Seen = std::function<std::vector<InterfaceName>()>;

  EdgeHealth(SystemReports& reports, Seen seen, QObject* parent = nullptr);

 public Q_SLOTS:
  /// Starts or stops the polling.
  void setLooking(bool looking);
  /// Polls the next connections.
  void look();
  /// Polls this connection now and in each look(), and emits its known counts at once. With an
  /// empty text, look() prefers no connection.
  void point(const QString& required);

 Q_SIGNALS:
  /// The result of a check. An empty warning means that the connection has no problem.
  void found(const tendon::InterfaceName& required, const QString& warning);
  /// The counters of the connection under the pointer, or the reason why they are unknown.
  void counted(const tendon::InterfaceName& required, const QStringList& lines);

 private:
  void ask(const InterfaceName& required);
  void onCounts(const InterfaceName& required, const Result<ConnectionCounts>& counts);

  SystemReports& reports_;
  Seen seen_;
  QTimer second_;
  InterfaceName last_;             // the connection that was polled last
  std::set<InterfaceName> asked_;  // connections whose reply has not arrived yet
  std::optional<InterfaceName> pointed_;
  std::map<InterfaceName, ConnectionCounts> known_;
};

}  // namespace tendon::gui
