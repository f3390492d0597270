#pragma once

#include <tendon/base/clock.h>
#include <tendon/task/component.h>

#include <condition_variable>
#include <mutex>
#include <set>

namespace tendon {

/// Whether `component` runs after `leader`, or after one that does.
[[nodiscard]] bool RunsAfter(const Component& component, const Component& leader);

/// Which components are asked something now: one request at a time for each, while others are
/// asked something, too. Everything here is called with the owner's lock held.
class Turns {
 public:
  /// The time in which a component is asked by one.
  class Turn {
   public:
    /// Lets go of the lock until no other request of the component is under way, but at least for
    /// kShortest; it is not ours where one still is by `deadline`.
    Turn(Turns& turns, const Component& component, std::unique_lock<std::recursive_mutex>& lock,
         SteadyTime deadline);
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn();

    [[nodiscard]] bool is_ours() const { return is_ours_; }

   private:
    Turns& turns_;
    const Component& component_;
    bool is_ours_ = true;
  };

  /// Whether a request is under way of it, or of one that runs after it: it must stay then, and so
  /// must its leader.
  [[nodiscard]] bool IsInUse(const Component& component) const;

  static constexpr std::chrono::milliseconds kShortest{20};

 private:
  std::set<const Component*> asked_;
  std::condition_variable_any ended_;
};

}  // namespace tendon
