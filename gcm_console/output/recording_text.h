#pragma once

#include <tendon/recording/mcap/chunk.h>

#include <cstdint>
#include <string>
#include <vector>

namespace console {

/// Formats a size: "17 B", "1.2 MB", "40.0 GB". The units are powers of 1000, as for disks.
[[nodiscard]] std::string SizeText(std::uint64_t bytes);

/// Returns one line for each listed problem of a file, and a line with the number of further
/// problems.
[[nodiscard]] std::vector<std::string> ProblemTexts(
    const std::vector<tendon::mcap::Problem>& problems, std::uint64_t count);

}  // namespace console
