#pragma once

#include <cstddef>
#include <span>
#include <string_view>

/// Feeds arbitrary bytes to the decoders of untrusted bytes.
namespace fuzz {

using Bytes = std::span<const std::byte>;

/// Feeds the bytes to one decoder. If the decoder breaks a guarantee, ends the process with a
/// message, as a sanitizer would.
struct Target {
  std::string_view name;
  void (*run)(Bytes bytes);
};

/// All targets. The folder with the target's name in corpus/ has the first inputs.
[[nodiscard]] std::span<const Target> Targets();

}  // namespace fuzz
