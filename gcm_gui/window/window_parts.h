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
class SignalSource;
class SystemActions;
class SystemReports;

/// What a window shows and steers; all of it outlives the window. Session has it all, a test puts
/// it together by hand.
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
  QString read_only{};  ///< why nothing can be changed from this window; empty where it can
};

}  // namespace tendon::gui
