#pragma once

#include <gcm_console/line/settings.h>

#include <QString>

namespace tendon::gui {

class ActivityModel;
class CatalogueStore;
class CommandCalls;
class ConnectionChecks;
class GcmLink;
class PlanRunner;
class Session;
class SignalSource;
class SystemActions;
class SystemReports;

/// What a window shows and steers; all of it outlives the window.
struct WindowParts {
  CatalogueStore& store;
  GcmLink& link;
  ActivityModel& activity;
  SystemActions& actions;
  SignalSource& source;
  CommandCalls& calls;
  ConnectionChecks& checks;
  PlanRunner& plans;
  SystemReports& reports;
  console::Settings console = {};  ///< of the console in the window
  QString kept = {};               ///< the folder of what is kept for the next time; empty: none
  QStringList gcm = {};            ///< `gcm` with its options; empty: none is started from here
  QString demo = {};               ///< the system file of the demo; empty: none is offered
  QString read_only = {};          ///< why nothing can be changed from here; empty where it can
};

/// The parts that a session has.
[[nodiscard]] WindowParts PartsOf(Session& session);

}  // namespace tendon::gui
