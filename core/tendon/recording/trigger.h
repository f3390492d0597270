#pragma once

#include <tendon/base/clock.h>
#include <tendon/recording/condition.h>
#include <tendon/recording/recorded_system.h>

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace tendon::recording {

/// Watches a condition in a running system: evaluates it for every row of its table, or waits for
/// its events or for the executed calls of its command. A trigger has its own subscription, so the
/// paths of the recording need not include the condition. A recorder has one trigger for its start
/// and one for its end.
///
/// Thread safety: any thread may call all functions, but handlers and sinks may not. Cost: a
/// comparison for each row, in a thread of the middleware.
class Trigger {
 public:
  /// Subscribes at once. `on_match` is called after new matches, in a thread of the middleware; it
  /// must not block. Waits for the type of the column. Fails with kNotFound if the path does not
  /// exist now (the error suggests another path), and like CellTest::Make(). `system` must outlive
  /// the trigger.
  static Result<std::unique_ptr<Trigger>> Make(RecordedSystem& system, const Condition& condition,
                                               std::function<void()> on_match);
  Trigger(const Trigger&) = delete;
  Trigger& operator=(const Trigger&) = delete;
  /// Ends the subscription.
  ~Trigger();

  /// Returns the time of the first row, event or call after `time` for which the condition was
  /// true, on this process's steady clock. Forgets all earlier matches. Only the newest 4096
  /// matches are kept.
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
