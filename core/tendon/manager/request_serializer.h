#pragma once

#include <tendon/base/clock.h>
#include <tendon/task/component.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>

namespace tendon {

/// Lets only one request at a time be in progress for each component. Requests for different
/// components may overlap. All functions must be called while the owner's lock is held.
class RequestSerializer {
 public:
  /// The right to make one request for a component.
  class Turn {
   public:
    /// Waits until no other request for the component is in progress, and releases the lock during
    /// the wait. Gives up at `deadline`, but not before kShortest has passed; then is_ours() is
    /// false.
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

  /// Returns true if a request for `component`, or for a component that runs after it, is in
  /// progress. Then the component must not be removed, and its leader must not be changed.
  [[nodiscard]] bool IsInUse(const Component& component) const;

  static constexpr std::chrono::milliseconds kShortest{20};

 private:
  std::set<const Component*> in_progress_;
  std::condition_variable_any ended_;
};

}  // namespace tendon
