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

/// Checks that the process of the order is present. For all verbs except "create" and "load", also
/// checks that the process has the component. Fails like the functions of lookup.h, and with
/// kFailed if the process was restarted after the order was made.
Result<void> CheckTarget(const Catalogue& catalogue, const message::LifecycleOrder& order);

/// Like CheckTarget(), but also fails if the catalogue shows that the process would refuse the
/// order. Used for previews.
Result<void> CheckLifecycleOrder(const Catalogue& catalogue, const message::LifecycleOrder& order);

/// Returns the components that match `pattern`, sorted by path. The pattern is a path such as
/// "robot/arm", or a glob, which searches all present processes. Fails with kNotFound if no
/// component matches.
Result<std::vector<Path>> LookUpComponents(const Catalogue& catalogue, const std::string& pattern);
/// Like LookUpComponents(), but fails with kInvalid if several components match.
Result<Path> LookUpOneComponent(const Catalogue& catalogue, const std::string& pattern);

/// Returns the verb with which the history records an order. A restart is recorded as a start.
[[nodiscard]] std::string StepVerbOf(const message::LifecycleOrder& order);

/// Returns true if the component was active before and after the step, for example for a restart.
/// Then there is nothing to undo.
[[nodiscard]] bool LeavesAsItWas(const message::HistoryEntry& step);

/// Returns the data about an order that the history needs. Must be called before the order is
/// executed. If the order cannot be undone (load), the process in the result is empty.
[[nodiscard]] message::LifecycleStep StepOf(const Catalogue& catalogue,
                                            const message::LifecycleOrder& order);

/// Adds the outcome of an order to its step: the state before the order, and the values that the
/// process actually used.
void AddOutcome(const message::LifecycleOutcome& outcome, message::HistoryEntry& step);

/// Checks that the component has not changed since the step.
Result<void> CheckUndo(const Catalogue& catalogue, const message::HistoryEntry& step);

/// The orders that undo a step. Connections are restored after `first` and before `then`. For a
/// step that removed a component, `first` creates the component, and `then` starts it.
struct UndoPlan {
  std::vector<message::LifecycleOrder> first;
  std::vector<message::LifecycleOrder> then;
};

/// Returns the time limit for an order: at most `timeout`, but short enough that the reply
/// arrives within `left`. The reply to an order may take one and a half times its time limit.
/// Returns nothing if too little time is left.
[[nodiscard]] std::optional<std::chrono::nanoseconds> TimeoutWithin(
    std::chrono::nanoseconds timeout, std::chrono::nanoseconds left);

/// Returns the orders that undo a step. Each order has the time limit `timeout`, and is valid only
/// for the process instance that made the step.
[[nodiscard]] UndoPlan PlanUndo(const message::HistoryEntry& step,
                                std::chrono::nanoseconds timeout);

}  // namespace tendon
