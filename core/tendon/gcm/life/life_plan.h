#pragma once

#include <tendon/base/path.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/messages.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

/// Orders for the life of components, judged and unmade by what a catalogue says.
namespace tendon {

/// Whether there is somebody to be given the order: the process that is meant is there, and so is
/// its component, unless that is to be created. Errors as those of lookup.h; kFailed where the
/// process was started anew since.
Result<void> CheckTarget(const Catalog& catalog, const message::LifeOrder& order);

/// The same, and whether the process would refuse it, as far as the catalogue knows: for who only
/// wants to see what would happen.
Result<void> CheckLife(const Catalog& catalog, const message::LifeOrder& order);

/// The components that `pattern` names: "robot/arm", or with stars those of all processes that are
/// there, in the order of their paths. kNotFound where there is none.
Result<std::vector<Path>> LookUpComponents(const Catalog& catalog, const std::string& pattern);

/// What the history calls an order: a restart of what does not run is a start.
[[nodiscard]] std::string StepVerbOf(const message::LifeOrder& order);

/// Whether there is nothing to take back: who was active is so after a restart too.
[[nodiscard]] bool LeavesAsItWas(const message::HistoryEntry& step);

/// What the history must keep of an order that is about to be given. Without a process where it is
/// not undoable: load.
[[nodiscard]] message::LifeStep StepOf(const Catalog& catalog, const message::LifeOrder& order);

/// Completes the step by what the process says was there before, and how it understood the order.
void AddOutcome(const message::LifeOutcome& outcome, message::HistoryEntry& step);

/// Whether the component is still as the step left it.
Result<void> CheckUndo(const Catalog& catalog, const message::HistoryEntry& step);

/// What unmakes a step. A component that was removed is there again after the `first`, gets its
/// connections, and runs after the others.
struct UndoPlan {
  std::vector<message::LifeOrder> first;
  std::vector<message::LifeOrder> then;
};

/// That of an order which is to be answered within `left`, half as long again as it may take; none
/// where there is no time for it.
[[nodiscard]] std::optional<std::chrono::nanoseconds> PatienceWithin(
    std::chrono::nanoseconds patience, std::chrono::nanoseconds left);

/// `patience` is that for each order; they are meant for the instance that made the step.
[[nodiscard]] UndoPlan PlanUndo(const message::HistoryEntry& step,
                                std::chrono::nanoseconds patience);

}  // namespace tendon
