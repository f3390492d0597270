#pragma once

#include <gtest/gtest.h>
#include <tendon/base/clock.h>
#include <tendon/task/task.h>

#include <chrono>
#include <concepts>

namespace tendon_test {

/// A task without a thread. The test runs the cycles in its own thread, and sets the time.
template <std::derived_from<tendon::Task> T>
class Stepped final : public T {
 public:
  using T::T;

  /// Makes `count` cycles. Returns false if the task is faulted.
  bool Cycle(int count = 1) {
    bool is_good = true;
    for (int i = 0; i < count; ++i) {
      // Executes pending orders of the framework, such as a disconnect.
      if (this->has_orders()) this->ObeyOrders();
      now_ += std::chrono::nanoseconds(static_cast<std::int64_t>(this->period() * 1e9));
      is_good = this->DoCycle(now_);
    }
    return is_good;
  }

  /// Returns the newest value of a column.
  template <typename Value>
  Value Read(const char* column) {
    Value value{};
    const auto* found =
        dynamic_cast<const tendon::Column<Value>*>(this->state_table().Find(column));
    EXPECT_NE(found, nullptr) << column;
    if (found == nullptr) return value;
    EXPECT_TRUE(found->ReadNewest(value)) << column;
    return value;
  }

 private:
  tendon::Result<void> Launch() override {
    this->SetState(tendon::ComponentState::kActive);
    return {};
  }
  void Pause() override { this->SetState(tendon::ComponentState::kSuspended); }
  tendon::Result<void> Resume() override {
    if (this->ReportResume()) this->SetState(tendon::ComponentState::kActive);
    return {};
  }
  void Halt() override { this->SetState(tendon::ComponentState::kFinished); }

  tendon::SteadyTime now_{std::chrono::seconds(1)};
};

}  // namespace tendon_test
