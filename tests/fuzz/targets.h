#pragma once

#include <cstddef>
#include <span>
#include <string_view>

/// What reads bytes from outside, fed with bytes of any kind.
namespace fuzz {

using Bytes = std::span<const std::byte>;

/// Feeds the bytes to one decoder; ends the process with a sentence where it breaks a promise, as
/// a sanitizer would.
struct Target {
  std::string_view name;
  void (*run)(Bytes bytes);
};

/// All of them; the folder of that name in corpus/ has where to begin.
[[nodiscard]] std::span<const Target> Targets();

}  // namespace fuzz
