#pragma once

namespace tendon::gui {

class ActivityModel;
class CatalogueStore;
class CommandCalls;
class ConnectionChecks;
class GcmLink;
class SignalSource;
class SystemActions;

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
};

}  // namespace tendon::gui
