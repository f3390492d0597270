#pragma once

#include <tendon/base/clock.h>
#include <tendon/recording/condition.h>
#include <tendon/recording/recorded_system.h>

#include <functional>
#include <memory>
#include <optional>

namespace tendon::recording {

/// Watches a condition in a running system: evaluates it for every row of its table, or waits for
/// each of its events, or for each executed call of its command. It has a subscription of its own,
/// so the paths of the recording need not include the condition. A recorder has one for its begin
/// and one for its end.
///
/// Thread safety: all functions, from any thread except handlers and sinks. Cost: a comparison for
/// each row, in a thread of the middleware.
class Trigger {
 public:
  /// Subscribes at once. `on_match` is called after new matches, in a thread of the middleware; it
  /// must not block. Waits for the type of the column. kNotFound, with a suggestion, if the path
  /// does not exist now; otherwise as CellTest::Make(). `system` must outlive the trigger.
  static Result<std::unique_ptr<Trigger>> Make(RecordedSystem& system, const Condition& condition,
                                               std::function<void()> on_match);
  Trigger(const Trigger&) = delete;
  Trigger& operator=(const Trigger&) = delete;
  /// Ends the subscription.
  ~Trigger();

  /// The time of the first row, event or call after `time` for which the condition was true, on
  /// this process's steady clock; forgets all earlier ones. The newest 4096 matches are kept.
  [[nodiscard]] std::optional<SteadyTime> FirstAfter(SteadyTime time);

 private:
  class Matches;
  class TableWatch;
  class EventWatch;

  Trigger(RecordedSystem& system, std::shared_ptr<Matches> matches)
      : system_(system), matches_(std::move(matches)) {}
  Result<void> WatchTable(const Condition& condition, const Catalogue& catalogue);
  Result<void> WatchEvent(const Condition& condition, const Catalogue& catalogue);

  RecordedSystem& system_;
  const std::shared_ptr<Matches> matches_;
  std::optional<TelemetryClient::Id> table_;
  std::optional<GcmClient::ListenerId> event_;
};

}  // namespace tendon::recording
