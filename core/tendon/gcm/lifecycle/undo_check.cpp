#include <tendon/gcm/lifecycle/undo_check.h>

#include <tendon/gcm/lifecycle/lifecycle_plan.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>

namespace tendon {
namespace {

/// Checks that the connection has not changed since the step, and that it can be restored.
Result<void> CheckConnectionStep(const Catalogue& catalogue, const message::History& history,
                                 const message::HistoryEntry& step) {
  const InterfaceName& needed = step.ends.required;
  const std::string required = ToString(needed);
  if (const auto found = LookUpRequired(catalogue, needed); !found) return found.error();
  const auto* now = catalogue.FindConnection(needed);
  if (step.verb != "disconnect" && now == nullptr) {
    return Error{ErrorCode::kFailed,
                 required + " is no longer connected to " + ToString(step.ends.provided)};
  }
  if (now != nullptr && now->provided != step.ends.provided) {
    return Error{ErrorCode::kFailed, required + " is now connected to " + ToString(now->provided)};
  }
  if (step.verb == "connect" || (step.verb == "disconnect" && now != nullptr)) return {};
  if (WasPending(catalogue, history, step)) return {};
  const bool swaps = step.verb == "replace";
  const auto planned = PlanConnect(catalogue, {needed, swaps ? step.former : step.ends.provided},
                                   WhenConnected::kReplace);
  return planned ? Result<void>() : planned.error();
}

}  // namespace

Error CannotUndo(const message::HistoryEntry& step, const Error& why) {
  return {why.code, "cannot undo " + WholeText(step) + ": " + why.message};
}

Error CannotUndoNow(const message::HistoryEntry& step, const std::string& why) {
  const std::string joint = why.ends_with("?") ? " " : "; ";
  const std::string next = "to skip this step and undo the step before it: gcm undo --skip";
  return CannotUndo(step, {ErrorCode::kFailed, why + joint + next});
}

bool WasPending(const Catalogue& catalogue, const message::History& history,
                const message::HistoryEntry& step) {
  const bool is_replacement = step.verb == "replace";
  const InterfaceName& provided = is_replacement ? step.former : step.ends.provided;
  const ProcessEntry* provider = catalogue.FindProcess(provided.process);
  const bool is_of_both = is_replacement || step.verb == "disconnect";
  if (!is_of_both || provider == nullptr ||
      catalogue.FindComponent(provided.process, provided.component) != nullptr) {
    return false;
  }
  bool was_removed = false;
  for (const message::HistoryEntry& one : history.entries) {
    const message::LifecycleStep& lifecycle = one.lifecycle;
    if (one.id >= step.id) break;
    if (one.undone || one.instance != provider->process.instance ||
        lifecycle.process != provided.process || lifecycle.component != provided.component) {
      continue;
    }
    if (one.verb == ToString(LifecycleVerb::kRemove)) was_removed = true;
    if (one.verb == ToString(LifecycleVerb::kCreate)) was_removed = false;
  }
  return was_removed;
}

Result<void> CheckUndoOf(const Catalogue& catalogue, const message::History& history,
                         const message::HistoryEntry& step) {
  const std::string& process = ProcessOf(step);
  const auto owner = LookUpProcess(catalogue, process);
  if (!owner) return CannotUndoNow(step, owner.error().message);
  if (const auto present = RequirePresent((*owner)->process); !present) {
    return CannotUndo(step, {ErrorCode::kFailed, present.error().message +
                                                     "; try again when the process is back; or, to "
                                                     "remove it from the catalogue: gcm forget " +
                                                     process});
  }
  if ((*owner)->process.instance != step.instance) {
    return CannotUndoNow(step, "process '" + process + "' was restarted since");
  }
  if (IsProcessStep(step)) return {};
  const auto checked = IsLifecycleStep(step) ? CheckUndo(catalogue, step)
                                             : CheckConnectionStep(catalogue, history, step);
  return checked ? checked : CannotUndoNow(step, checked.error().message);
}

}  // namespace tendon
