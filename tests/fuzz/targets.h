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
  std::string_view corpus = name;  ///< the folder in corpus/ with the first inputs
  int rounds = 2500;               ///< of random mutations in every test run
};

[[nodiscard]] std::span<const Target> Targets();

}  // namespace fuzz
