#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

/// Checks and undoes lifecycle orders, based on a catalogue.
namespace tendon {

/// Checks that the order can be given: its process is present, and so is its component, except for
/// "create". Errors are those of lookup.h; kFailed if the process was restarted since.
Result<void> CheckTarget(const Catalogue& catalogue, const message::LifecycleOrder& order);

/// Like CheckTarget(), but also checks whether the process would refuse the order, as far as the
/// catalogue knows this. For a preview.
Result<void> CheckLifecycleOrder(const Catalogue& catalogue, const message::LifecycleOrder& order);

/// The components that match `pattern`: "robot/arm", or a glob over all present processes; sorted
/// by path. kNotFound if there is none.
Result<std::vector<Path>> LookUpComponents(const Catalogue& catalogue, const std::string& pattern);

/// The verb of an order in the history; a restart of a stopped component is recorded as a start.
[[nodiscard]] std::string StepVerbOf(const message::LifecycleOrder& order);

/// True if there is nothing to undo, for example after a restart of an active component.
[[nodiscard]] bool LeavesAsItWas(const message::HistoryEntry& step);

/// The data that the history needs for an order. Call it before the order is executed. The process
/// is empty if the order cannot be undone (load).
[[nodiscard]] message::LifecycleStep StepOf(const Catalogue& catalogue,
                                            const message::LifecycleOrder& order);

/// Adds to the step the former state, and the values that the process actually used.
void AddOutcome(const message::LifecycleOutcome& outcome, message::HistoryEntry& step);

/// Checks that the component is still as the step left it.
Result<void> CheckUndo(const Catalogue& catalogue, const message::HistoryEntry& step);

/// The orders that undo a step. For a removed component, `first` creates it, then it gets its
/// connections, and `then` starts it.
struct UndoPlan {
  std::vector<message::LifecycleOrder> first;
  std::vector<message::LifecycleOrder> then;
};

/// The time limit to send with an order: at most `patience`, and short enough that the answer
/// arrives within `left`. The answer to an order may take one and a half times its time limit.
/// Empty if no time is left.
[[nodiscard]] std::optional<std::chrono::nanoseconds> PatienceWithin(
    std::chrono::nanoseconds patience, std::chrono::nanoseconds left);

/// `patience` is for each order. The orders are for the instance that made the step.
[[nodiscard]] UndoPlan PlanUndo(const message::HistoryEntry& step,
                                std::chrono::nanoseconds patience);

}  // namespace tendon
