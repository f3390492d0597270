#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/task/component.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace tendon {

/// Stops components so that the last calls of their Cleanup() are executed: a component is stopped
/// only after its clients have ended and their calls are executed. Components that do not depend on
/// each other stop at the same time.
class OrderlyShutdown {
 public:
  /// A component, and the components that end before it.
  struct Member {
    std::shared_ptr<Component> component;
    std::vector<std::size_t> before;  ///< indices of the members that end before this one; all are
                                      ///< smaller than its own
  };
  /// How to stop components, and how to query them.
  struct Actions {
    std::function<bool(const Component&)> is_at_rest;
    /// Requests the stop. kTimeout: the request was not possible now, and is repeated later.
    std::function<Result<void>(const std::shared_ptr<Component>&)> stop;
    /// True if calls that the component has sent are still to be executed.
    std::function<bool(const Component&)> has_calls_under_way;
  };

  OrderlyShutdown(std::vector<Member> members, Actions actions);

  /// Returns when all components have ended. At `deadline`, requests the stop of all that are left,
  /// even if others still call them, and returns kGrace later. Returns the first error; the log
  /// names the components whose last calls were not executed in time.
  Result<void> Run(SteadyTime deadline);

  static constexpr std::chrono::milliseconds kGrace{100};
  /// Time limit for the last calls of an ended component.
  static constexpr std::chrono::milliseconds kDrainPatience{1300};

  /// Logs that the last calls of `client` were not executed in time.
  static void LogNotExecuted(const Component& client);

 private:
  enum class Phase {
    kWaits,  ///< for members that end before it
    kRequested,
    kEnded,  ///< but its last calls may still wait
    kDone,
  };

  bool Advance();
  void Advance(std::size_t place);
  void RequestStop(std::size_t place);
  void BeginDrain(std::size_t place);
  void Wait();
  void GiveUp();
  void RecordResult(const Result<void>& result);

  const std::vector<Member> members_;
  const Actions actions_;
  std::vector<Phase> phases_;
  std::vector<SteadyTime> drained_by_;  // latest time for the last calls
  Result<void> outcome_;
};

}  // namespace tendon
