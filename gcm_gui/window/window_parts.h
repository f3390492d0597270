#pragma once

#include <gcm_console/command_line/settings.h>

#include <QString>
#include <QStringList>

namespace tendon::gui {

class ActivityModel;
class CatalogueStore;
class CommandCalls;
class ConnectionChecks;
class LinkState;
class PlanRunner;
class GcmSession;
class SignalSource;
class SystemActions;
class SystemReports;

/// The objects that a window shows and controls; all must outlive the window.
struct WindowParts {
  CatalogueStore& store;
  LinkState& link;
  ActivityModel& activity;
  SystemActions& actions;
  SignalSource& source;
  CommandCalls& calls;
  ConnectionChecks& checks;
  PlanRunner& plans;
  SystemReports& reports;
  console::Settings console = {};  ///< of the window's console
  QString kept = {};               ///< the folder for saved state; empty: none
  QStringList gcm = {};            ///< `gcm` with its options; empty: the window starts no GCM
  QString demo = {};               ///< the system file of the demo; empty: no demo is offered
  QString read_only = {};          ///< why this window cannot change anything; empty if it can
};

/// The parts that belong to a session.
[[nodiscard]] WindowParts PartsOf(GcmSession& session);

}  // namespace tendon::gui
