#pragma once

#include <tendon/payload/payload.h>

#include <type_traits>
#include <utility>

namespace tendon {

/// Computes one variable from another, once per row.
class RowFilter {
 public:
  RowFilter() = default;
  RowFilter(const RowFilter&) = delete;
  RowFilter& operator=(const RowFilter&) = delete;
  virtual ~RowFilter() = default;

  /// Called in the writer's thread before each row.
  virtual void Apply() noexcept = 0;
};

/// Calls `function(input, output)`. The function may have its own state.
template <Payload In, Payload Out, typename Function>
class FunctionFilter final : public RowFilter {
 public:
  static_assert(
      std::is_nothrow_invocable_r_v<void, Function&, const In&, Out&>,
      "a filter is a function of (const In&, Out&) that runs in the cycle: declare it noexcept");

  FunctionFilter(const In& input, Out& output, Function function)
      : input_(input), output_(output), function_(std::move(function)) {}

  void Apply() noexcept override { function_(input_, output_); }

 private:
  const In& input_;
  Out& output_;
  Function function_;
};

}  // namespace tendon
