#pragma once

#include <cstdint>
#include <string>

namespace tendon {

/// Fails the test if this thread allocates while the guard lives. Other threads may allocate.
///
///     const AllocationGuard guard;
///     EXPECT_EQ(arm.move_to(JointGoal{}), Status::kQueued);
class AllocationGuard {
 public:
  AllocationGuard() noexcept;
  /// Reports the number of calls of `operator new`.
  ~AllocationGuard();
  AllocationGuard(const AllocationGuard&) = delete;
  AllocationGuard& operator=(const AllocationGuard&) = delete;

  /// Calls of `operator new` in this thread since the guard was created.
  [[nodiscard]] std::uint64_t allocations() const noexcept;

 private:
  std::uint64_t before_;
};

}  // namespace tendon
