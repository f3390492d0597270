#pragma once

#include <algorithm>
#include <cstdint>

namespace tendon::gui {

/// The losses of rows of one source since its subscription, by place.
struct RowLosses {
  std::uint64_t table = 0;    ///< in its process: overwritten before they could be read
  std::uint64_t network = 0;  ///< refused by the link, or written while there was no link
  std::uint64_t viewer = 0;   ///< in this window

  /// The losses after `before`.
  [[nodiscard]] RowLosses since(const RowLosses& before) const {
    const auto rest = [](std::uint64_t now, std::uint64_t then) {
      return now - std::min(now, then);
    };
    return {rest(table, before.table), rest(network, before.network), rest(viewer, before.viewer)};
  }
  bool operator==(const RowLosses&) const = default;
};

}  // namespace tendon::gui
