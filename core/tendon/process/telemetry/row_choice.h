#pragma once

#include <tendon/payload/payload.h>

#include <chrono>
#include <cstdint>

namespace tendon {

/// The treatment of rows that a viewer cannot receive yet.
enum class RowDelivery : std::uint8_t {
  kAll,    ///< rows wait on the link while it has room; the rest is lost and counted
  kNewest  ///< a newer row replaces an unsent one; no row waits or counts as lost
};

/// The rows of a state table that a viewer wants.
struct RowChoice {
  /// If 0, the viewer gets every row. Otherwise it gets the first row in each period of the
  /// source's steady clock. Therefore, all viewers with the same period get the same rows.
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
