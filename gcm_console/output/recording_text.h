#pragma once

#include <tendon/recording/chunk_compression.h>
#include <tendon/recording/mcap_chunk.h>

#include <cstdint>
#include <string>
#include <vector>

namespace console {

/// "17 B", "1.2 MB", "40.0 GB": powers of 1000, as disks are sold.
[[nodiscard]] std::string SizeText(std::uint64_t bytes);

/// The compression of that name: "zstd", "lz4" or "none".
[[nodiscard]] tendon::mcap::Compression CompressionNamed(const std::string& name);

/// A line for each problem of a file, and how many more there are.
[[nodiscard]] std::vector<std::string> ProblemTexts(
    const std::vector<tendon::mcap::Problem>& problems, std::uint64_t count);

}  // namespace console
