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

/// Stops components so that what their Cleanup() sends last is executed: each is asked to stop once
/// those that call it have ended and what they have sent is executed. Those that do not depend on
/// each other stop at the same time.
class OrderlyEnd {
 public:
  /// One of the components, and which of the others end before it.
  struct Member {
    std::shared_ptr<Component> component;
    std::vector<std::size_t> before;  ///< the places in the list, all smaller, of those that end
                                      ///< before it
  };
  /// How components are asked, and what is known of them.
  struct Actions {
    std::function<bool(const Component&)> is_at_rest;
    /// Asks it to stop; kTimeout: it could not be asked now, and is asked again.
    std::function<Result<void>(const std::shared_ptr<Component>&)> stop;
    /// Whether calls that it has sent are still to be executed.
    std::function<bool(const Component&)> has_calls_under_way;
  };

  OrderlyEnd(std::vector<Member> members, Actions actions);

  /// Returns once all have ended. At `deadline` those that could not be asked before are asked,
  /// whatever still calls them, and kGrace later it returns. The first error; the log says whose
  /// last calls were not executed in time.
  Result<void> Run(SteadyTime deadline);

  static constexpr std::chrono::milliseconds kGrace{100};
  /// For what one has sent last, once it has ended.
  static constexpr std::chrono::milliseconds kDrainPatience{1300};

  /// What `client` has sent last is not waited for any longer.
  static void LogNotExecuted(const Component& client);

 private:
  enum class Phase {
    kWaits,  ///< for those that end before it
    kAsked,
    kEnded,  ///< what it has sent may still be under way
    kDone,
  };

  bool Advance();
  void Advance(std::size_t place);
  void Ask(std::size_t place);
  void BeginDrain(std::size_t place);
  void Wait();
  void GiveUp();
  void Note(const Result<void>& result);

  const std::vector<Member> members_;
  const Actions actions_;
  std::vector<Phase> phases_;
  std::vector<SteadyTime> drained_by_;  // at the latest
  Result<void> outcome_;
};

}  // namespace tendon
