#pragma once

#include <tendon/payload/payload.h>

#include <chrono>
#include <cstdint>

namespace tendon {

/// What becomes of rows that a viewer is not ready for.
enum class RowDelivery : std::uint8_t {
  kAll,    ///< they wait on the link, as far as that has room; the others are lost, and counted
  kNewest  ///< a newer one takes the place of what has not been sent: nothing waits, none is lost
};

/// Which rows of a state table a viewer wants.
struct RowChoice {
  /// 0: every row. Otherwise the first row of each such stretch of the source's steady clock: at
  /// most so many a second, the same ones for whoever asks for the same period.
  std::chrono::nanoseconds period{0};
  RowDelivery delivery = RowDelivery::kAll;

  bool operator==(const RowChoice&) const = default;
};

}  // namespace tendon

template <>
inline constexpr auto tendon::kPayload<tendon::RowDelivery> =
    tendon::DescribeEnum("tendon.RowDelivery", tendon::Enumerator{"ALL", tendon::RowDelivery::kAll},
                         tendon::Enumerator{"NEWEST", tendon::RowDelivery::kNewest});

template <>
inline constexpr auto tendon::kPayload<tendon::RowChoice> =
    tendon::Describe("tendon.RowChoice", tendon::Field{"period", &tendon::RowChoice::period},
                     tendon::Field{"delivery", &tendon::RowChoice::delivery});
