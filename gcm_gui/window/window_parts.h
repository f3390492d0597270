#pragma once

#include <QString>

namespace tendon::gui {

class ActivityModel;
class CatalogueStore;
class CommandCalls;
class GcmLink;
class PlanRunner;
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
  PlanRunner& plans;
  QString read_only{};  ///< why nothing can be changed from this window; empty where it can
};

}  // namespace tendon::gui
