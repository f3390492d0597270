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
class RecordingRunner;
class ReplaySession;
class GcmSession;
class SignalSource;
class SystemActions;
class SystemReports;

/// The objects that a window shows and controls. All must outlive the window.
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
  RecordingRunner& recordings;
  console::Settings console = {};  ///< settings of the console in the window
  QString kept = {};               ///< folder for the saved state; if empty, nothing is saved
  QStringList gcm = {};  ///< `gcm` with its options; if empty, the window cannot start a GCM
  QString demo = {};     ///< system file of the demo; if empty, the demo is not offered
  /// The command that opens a recording in another window: this program with its options. If empty,
  /// the window does not offer this.
  QStringList viewer = {};
  ReplaySession* replay = nullptr;  ///< the recording that the window shows; null if it shows none
  QString read_only = {};  ///< the reason why this window cannot change anything; empty if it can
};

/// Returns the parts that belong to a session.
[[nodiscard]] WindowParts PartsOf(GcmSession& session);
[[nodiscard]] WindowParts PartsOf(ReplaySession& session);

}  // namespace tendon::gui
