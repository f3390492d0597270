#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/plot/marks/mark_track.h>
#include <gcm_gui/session/catalogue_store.h>

#include <QObject>
#include <QString>
#include <map>
#include <string>
#include <utility>

namespace tendon::gui {

class PlotPanel;

/// Marks on the plots what happens to the system: the calls of this window and what is refused to
/// it, and whatever program caused them, states that change, connections that are made and broken,
/// processes that are lost and come back. What is there already when it is first heard of makes no
/// mark. GUI thread.
class MarkBinding : public QObject {
  Q_OBJECT

 public:
  MarkBinding(PlotPanel& panel, CatalogueStore& store, ActivityModel& activity,
              QObject* parent = nullptr);

 public Q_SLOTS:
  /// An event, "robot/arm/Control.GoalReached", with its value as JSON, which came at `when`, ns
  /// since 1970.
  void markEvent(const QString& path, const QString& value, qint64 when);

 private:
  void markAction(const Action& action);
  void compare(const Catalog& catalogue, const Touched& touched);
  void compareProcess(const Catalog& catalogue, const std::string& process);
  void compareComponent(const ProcessEntry& entry, const ComponentDescription& component);
  void compareConnections(const Catalog& catalogue, const TouchedPart& part);
  void add(Mark::Kind kind, const QString& label, const QString& text, bool is_bad);

  PlotPanel& panel_;
  std::map<std::string, ProcessState> processes_;
  std::map<std::pair<std::string, std::string>, ComponentState> components_;
  std::map<InterfaceName, InterfaceName> connections_;  // that stand: required, provided
};

}  // namespace tendon::gui
