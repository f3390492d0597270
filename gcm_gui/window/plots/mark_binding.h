#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/plot/marks/mark_track.h>
#include <gcm_gui/reports/system_reports.h>
#include <gcm_gui/session/catalogue_store.h>

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

/// Marks on the plots what happens to the system: the commands that this window and other programs
/// send, of those of others none that only read, what is refused, and whatever program caused them,
/// states that change, connections that are made and broken, processes that are lost and come back.
/// What is there already when it is first heard of makes no mark.
///
/// Of the components that are plotted it marks the events, too, and listens to those of no others;
/// to none while marks are hidden. GUI thread.
class MarkBinding : public QObject {
  Q_OBJECT

 public:
  /// Components whose events are listened to at once, in the order in which they were plotted.
  static constexpr qsizetype kMostListenedTo = 32;
  /// Events of the same path that come sooner after the one that is marked are counted with it.
  static constexpr std::int64_t kEventPauseNs = 50'000'000;

  /// All must outlive it.
  MarkBinding(PlotPanel& panel, CatalogueStore& store, ActivityModel& activity,
              SystemReports& reports, QObject* parent = nullptr);

 private:
  struct Marked {
    std::int64_t when = 0;  // of the event that is marked last, ns since 1970
    std::uint64_t unmarked = 0;
  };

  void follow();
  void markEvent(const HeardEvent& event);
  void markLog(const LogBatch& batch);
  [[nodiscard]] bool isRead(const QString& path) const;
  [[nodiscard]] bool isOwnCall(const QString& path) const;
  void markAction(const Action& action);
  void compare(const Catalog& catalogue, const Touched& touched);
  void compareProcess(const Catalog& catalogue, const std::string& process);
  void compareComponent(const ProcessEntry& entry, const ComponentDescription& component);
  void compareConnections(const Catalog& catalogue, const TouchedPart& part);
  void add(Mark::Kind kind, const QString& label, const QString& text, bool is_bad);

  PlotPanel& panel_;
  const CatalogueStore& store_;
  ActivityModel& activity_;
  SystemReports& reports_;
  QStringList components_plotted_;  // "robot/arm"
  QHash<QString, Marked> events_;   // of each path
  bool watches_log_ = false;
  bool log_is_current_ = false;
  std::map<std::string, ProcessState> processes_;
  std::map<std::pair<std::string, std::string>, ComponentState> components_;
  std::map<InterfaceName, InterfaceName> connections_;  // that stand: required, provided
};

}  // namespace tendon::gui
