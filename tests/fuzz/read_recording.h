#pragma once

#include <tendon/recording/mcap/reader.h>

#include <cstdint>

#include "targets.h"

namespace fuzz {

/// The limits are so small that a small file can exceed them.
inline constexpr tendon::mcap::ReaderLimits kSmallLimits{.chunk = std::uint64_t{1} << 20U,
                                                         .text = std::uint64_t{1} << 16U,
                                                         .attachment = std::uint64_t{1} << 16U,
                                                         .summary = std::uint64_t{1} << 16U,
                                                         .cache = std::uint64_t{1} << 16U};

/// Opens the bytes as an MCAP file, reads it in both orders, verifies it, and recovers it.
void ReadRecording(Bytes bytes);

}  // namespace fuzz
