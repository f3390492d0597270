#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/plot/series/mark_track.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_reports.h>

#include <QHash>
#include <QObject>
#include <QString>
#include <QStringList>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

namespace tendon::gui {

class PlotPanel;

/// Adds marks to the plots when the system changes: for commands of this window, commands of other
/// programs (except reads), refused requests, changes of state, connections made and broken, and
/// processes lost and returned. The cause of a change does not matter. The first known state is not
/// marked.
///
/// Also marks the events of the plotted components. Does not subscribe to the events of other
/// components. Subscribes to no events while marks are hidden. GUI thread.
class MarkBinding : public QObject {
  Q_OBJECT

 public:
  /// The maximum number of components whose events are subscribed at once, in the order of
  /// plotting.
  static constexpr qsizetype kMaxListenedTo = 32;
  /// The minimum time between two marked events of the same path. An event that comes earlier is
  /// only counted in the next mark.
  static constexpr std::int64_t kEventPauseNs = 50'000'000;

  /// All arguments must outlive this object.
  MarkBinding(PlotPanel& panel, CatalogueStore& store, ActivityModel& activity,
              SystemReports& reports, QObject* parent = nullptr);

 private:
  struct MarkedEvents {
    std::int64_t when = 0;  // time of the last marked event, ns since 1970
    std::uint64_t unmarked = 0;
  };

  void follow();
  /// Forgets what was marked and compared.
  void startOver();
  void markEvent(const EventRecord& event);
  void markLog(const LogBatch& batch);
  [[nodiscard]] bool isRead(const QString& path) const;
  [[nodiscard]] bool isOwnCall(const QString& path) const;
  void markAction(const Action& action);
  void compare(const Catalogue& catalogue, const ChangedParts& touched);
  void compareAll();
  void compareProcess(const Catalogue& catalogue, const std::string& process);
  void compareComponent(const ProcessEntry& entry, const ComponentDescription& component);
  void compareConnections(const Catalogue& catalogue, const ChangedPart& part);
  void add(Mark::Kind kind, const QString& label, const QString& text, bool is_bad);

  PlotPanel& panel_;
  const CatalogueStore& store_;
  ActivityModel& activity_;
  SystemReports& reports_;
  QStringList components_plotted_;       // "robot/arm"
  QHash<QString, MarkedEvents> events_;  // by path
  bool watches_log_ = false;
  bool log_is_current_ = false;
  std::map<std::string, ProcessState> processes_;
  std::map<std::pair<std::string, std::string>, ComponentState> components_;
  std::map<InterfaceName, InterfaceName> connections_;  // active connections: required, provided
};

}  // namespace tendon::gui
