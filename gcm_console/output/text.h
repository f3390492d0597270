#pragma once

#include <cstdio>
#include <string>

/// Small texts for the user.
namespace console {

/// Formats a number with `digits` decimals.
inline std::string Fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

/// Formats a number with four significant digits.
inline std::string Short(double value) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

/// Returns the words with `separator` between them: "a, b" for {"a", "b"} and ", ". Empty if there
/// are no words.
template <typename Words>
std::string Joined(const Words& words, const std::string& separator) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : separator) + word;
  return all;
}

}  // namespace console
