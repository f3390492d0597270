#include <tendon/manager/transition_to.h>

namespace tendon {
namespace {

bool IsAtRest(const LocalManager& manager, const std::string& component) {
  const auto settings = manager.SettingsOf(component);
  return !settings || settings->is_at_rest;
}

}  // namespace

Result<void> TransitionTo(LocalManager& manager, const std::string& component,
                          ComponentState wanted, Patience patience) {
  if (!IsRunning(wanted)) return {};
  auto done = manager.Start(component, patience);
  if (wanted == ComponentState::kActive) return done;
  if (done) done = manager.Suspend(component, patience);
  if (done || IsAtRest(manager, component)) return done;
  const auto stopped = manager.Stop(component, kPatience);
  const std::string before = "'" + component + "' could not be suspended: " + done.error().message;
  if (stopped || IsAtRest(manager, component)) {
    return Error{done.error().code, before + "; it was stopped instead"};
  }
  return Error{done.error().code,
               before + "; it may still run, because it does not stop: " + stopped.error().message};
}

}  // namespace tendon
