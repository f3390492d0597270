#pragma once

#include <QString>
#include <algorithm>
#include <cstdint>

namespace tendon::gui {

/// The rows of one source that were lost since its subscription, by the place of the loss. Filled
/// from tendon::LostRows. It is a separate type because plots depend only on Qt and Qwt.
struct RowLosses {
  std::uint64_t table = 0;    ///< lost in the source's process: overwritten before they were read
  std::uint64_t network = 0;  ///< refused by the link, or written while there was no link
  std::uint64_t viewer = 0;   ///< lost in this window

  /// Returns the losses that were added after `before`.
  [[nodiscard]] RowLosses since(const RowLosses& before) const {
    const auto rest = [](std::uint64_t now, std::uint64_t then) {
      return now - std::min(now, then);
    };
    return {rest(table, before.table), rest(network, before.network), rest(viewer, before.viewer)};
  }
  bool operator==(const RowLosses&) const = default;
};

/// Returns the numbers with their places: "600 in its process, 3 on the network". Empty if no row
/// was lost. `in_window` is the text for the rows lost in this window, such as "%1 in this window".
[[nodiscard]] QString LossPlaces(const RowLosses& losses, const QString& in_window);

}  // namespace tendon::gui
