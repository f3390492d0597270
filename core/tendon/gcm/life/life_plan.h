#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/gcm_messages.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

/// Checks and undoes life-cycle orders, based on a catalogue.
namespace tendon {

/// Whether the order can be given: its process is present, and so is its component, unless it is to
/// be created. Errors as those of lookup.h; kFailed if the process was restarted since.
Result<void> CheckTarget(const Catalogue& catalogue, const message::LifeOrder& order);

/// The same, and whether the process would refuse the order, as far as the catalogue knows. For a
/// preview.
Result<void> CheckLife(const Catalogue& catalogue, const message::LifeOrder& order);

/// The components that `pattern` names: "robot/arm", or with stars those of all present processes,
/// in the order of their paths. kNotFound if there is none.
Result<std::vector<Path>> LookUpComponents(const Catalogue& catalogue, const std::string& pattern);

/// The verb of an order in the history: a restart of a stopped component is a start.
[[nodiscard]] std::string StepVerbOf(const message::LifeOrder& order);

/// Whether there is nothing to undo, as after a restart of an active component.
[[nodiscard]] bool LeavesAsItWas(const message::HistoryEntry& step);

/// What the history must keep of an order before it is given. Without a process if it cannot be
/// undone: load.
[[nodiscard]] message::LifeStep StepOf(const Catalogue& catalogue, const message::LifeOrder& order);

/// Adds to the step what was there before, and how the process understood the order.
void AddOutcome(const message::LifeOutcome& outcome, message::HistoryEntry& step);

/// Whether the component is still as the step left it.
Result<void> CheckUndo(const Catalogue& catalogue, const message::HistoryEntry& step);

/// The orders that undo a step. For a removed component, `first` creates it, then it gets its
/// connections, and `then` starts it.
struct UndoPlan {
  std::vector<message::LifeOrder> first;
  std::vector<message::LifeOrder> then;
};

/// The longest patience, up to `patience`, with which the answer still comes within `left`: the
/// answer may take half the patience more. Nothing if there is no time.
[[nodiscard]] std::optional<std::chrono::nanoseconds> PatienceWithin(
    std::chrono::nanoseconds patience, std::chrono::nanoseconds left);

/// `patience` is for each order. The orders are for the instance that made the step.
[[nodiscard]] UndoPlan PlanUndo(const message::HistoryEntry& step,
                                std::chrono::nanoseconds patience);

}  // namespace tendon
