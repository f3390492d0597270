#pragma once

#include <tendon/base/clock.h>
#include <tendon/task/component.h>

#include <condition_variable>
#include <mutex>
#include <set>

namespace tendon {

/// True if `component` runs after `leader`, directly or through others.
[[nodiscard]] bool RunsAfter(const Component& component, const Component& leader);

/// Allows one request at a time for each component; requests of different components may overlap.
/// All functions are called with the owner's lock held.
class RequestSerializer {
 public:
  /// The right to make one request for a component.
  class Turn {
   public:
    /// Releases the lock and waits until no other request for the component is in progress. Gives
    /// up at `deadline`, but not before kShortest has passed; then is_ours() is false.
    Turn(RequestSerializer& serializer, const Component& component,
         std::unique_lock<std::recursive_mutex>& lock, SteadyTime deadline);
    Turn(const Turn&) = delete;
    Turn& operator=(const Turn&) = delete;
    ~Turn();

    [[nodiscard]] bool is_ours() const { return is_ours_; }

   private:
    RequestSerializer& serializer_;
    const Component& component_;
    bool is_ours_ = true;
  };

  /// True if a request for `component`, or for one that runs after it, is in progress. Then the
  /// component must not be removed, nor its leader changed.
  [[nodiscard]] bool IsInUse(const Component& component) const;

  static constexpr std::chrono::milliseconds kShortest{20};

 private:
  std::set<const Component*> in_progress_;
  std::condition_variable_any ended_;
};

}  // namespace tendon
