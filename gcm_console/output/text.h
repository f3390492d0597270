#pragma once

#include <tendon/base/text.h>

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

using tendon::Joined;

}  // namespace console
