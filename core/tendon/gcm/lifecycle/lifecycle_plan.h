#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

/// Functions that check lifecycle orders against a catalogue, and plan their undo.
namespace tendon {

/// Checks that the process of the order is present and, except for "create" and "load", has the
/// component. Fails like the functions of lookup.h, and with kFailed if the process was restarted
/// since the order was made.
Result<void> CheckTarget(const Catalogue& catalogue, const message::LifecycleOrder& order);

/// Like CheckTarget(), but also fails if the process would refuse the order, as far as the
/// catalogue shows this. Used for previews.
Result<void> CheckLifecycleOrder(const Catalogue& catalogue, const message::LifecycleOrder& order);

/// Returns the components that match `pattern`: a path such as "robot/arm", or a glob, for which
/// all present processes are searched. Sorted by path. Fails with kNotFound if no component
/// matches.
Result<std::vector<Path>> LookUpComponents(const Catalogue& catalogue, const std::string& pattern);

/// Returns the verb with which the history records an order. A restart is recorded as a start.
[[nodiscard]] std::string StepVerbOf(const message::LifecycleOrder& order);

/// Returns true if the step left the component active as it was before, for example a restart of an
/// active component. Then there is nothing to undo.
[[nodiscard]] bool LeavesAsItWas(const message::HistoryEntry& step);

/// Returns the data that the history needs for an order. Must be called before the order is
/// executed. The process in the result is empty if the order cannot be undone (load).
[[nodiscard]] message::LifecycleStep StepOf(const Catalogue& catalogue,
                                            const message::LifecycleOrder& order);

/// Adds the outcome of an order to its step: the state before the order, and the values that the
/// process actually used.
void AddOutcome(const message::LifecycleOutcome& outcome, message::HistoryEntry& step);

/// Checks that the component is still as the step left it.
Result<void> CheckUndo(const Catalogue& catalogue, const message::HistoryEntry& step);

/// The orders that undo a step. Connections are restored after `first` and before `then`. For
/// example, if the step removed a component, `first` creates it, and `then` starts it.
struct UndoPlan {
  std::vector<message::LifecycleOrder> first;
  std::vector<message::LifecycleOrder> then;
};

/// Returns the time limit to send with an order: at most `patience`, and short enough that the
/// answer arrives within `left`. The answer to an order may take one and a half times its time
/// limit. Empty if too little time is left.
[[nodiscard]] std::optional<std::chrono::nanoseconds> PatienceWithin(
    std::chrono::nanoseconds patience, std::chrono::nanoseconds left);

/// Returns the orders that undo a step, with `patience` as the time limit of each. They are valid
/// only for the process instance that made the step.
[[nodiscard]] UndoPlan PlanUndo(const message::HistoryEntry& step,
                                std::chrono::nanoseconds patience);

}  // namespace tendon
