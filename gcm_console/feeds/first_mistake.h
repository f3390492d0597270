#pragma once

#include <tendon/base/result.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace console {

/// Returns the first mistake of the feeds of several tables. If all paths of all feeds are left
/// out, returns kNotFound with the text `nothing_left`. `feed` is the member of a table that has
/// its feed, such as a RowInbox or a CurveFeed.
template <typename Table, typename Feed>
[[nodiscard]] std::optional<tendon::Error> FirstMistake(const std::vector<Table>& tables,
                                                        std::shared_ptr<Feed> Table::*feed,
                                                        const std::string& nothing_left) {
  bool is_any_left = false;
  for (const Table& table : tables) {
    if (auto mistake = (table.*feed)->mistake()) return mistake;
    is_any_left |= !(table.*feed)->is_empty();
  }
  if (is_any_left) return std::nullopt;
  return tendon::Error{tendon::ErrorCode::kNotFound, nothing_left};
}

}  // namespace console
