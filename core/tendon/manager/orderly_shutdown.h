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

/// Stops components in such an order that the last calls of their Cleanup() are executed: a
/// component is stopped only when its clients have ended and it has executed their calls.
/// Components that do not depend on each other are stopped at the same time.
class OrderlyShutdown {
 public:
  /// A component, and the components that must end before it.
  struct Member {
    std::shared_ptr<Component> component;
    /// The indices of the members that must end before this one. All are smaller than its own
    /// index.
    std::vector<std::size_t> before;
  };
  /// The functions that stop components and query them.
  struct Actions {
    std::function<bool(const Component&)> is_at_rest;
    /// Requests the stop of a component. A result kTimeout means that the request was not possible
    /// now; it is repeated later.
    std::function<Result<void>(const std::shared_ptr<Component>&)> stop;
    /// Returns true if calls that the component has sent are not executed yet.
    std::function<bool(const Component&)> has_calls_under_way;
  };

  OrderlyShutdown(std::vector<Member> members, Actions actions);

  /// Stops the components, and returns when all have ended. At `deadline`, requests the stop of all
  /// remaining components, even if others still call them, and returns at most kGrace later.
  /// Returns the first error. Logs a warning if last calls of a component were not executed in
  /// time.
  Result<void> Run(SteadyTime deadline);

  static constexpr std::chrono::milliseconds kGrace{100};
  /// Time limit for the last calls of an ended component.
  static constexpr std::chrono::milliseconds kLastCallsTimeout{1300};

  /// Logs that the last calls of `client` were not executed in time.
  static void LogNotExecuted(const Component& client);

 private:
  enum class Phase {
    kWaits,  ///< waits for the members that must end before it
    kRequested,
    kEnded,  ///< has ended, but its last calls may not be executed yet
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
  std::vector<SteadyTime> drained_by_;  // time limit for the last calls
  Result<void> outcome_;
};

}  // namespace tendon
