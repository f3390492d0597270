#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "targets.h"

namespace fuzz {

inline void Require(bool kept, const char* promise) {
  if (kept) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

/// Takes the first byte as a number below `count`.
inline std::size_t TakeChoice(Bytes& bytes, std::size_t count) {
  if (bytes.empty()) return 0;
  const std::size_t choice = std::to_integer<std::size_t>(bytes.front()) % count;
  bytes = bytes.subspan(1);
  return choice;
}

inline std::string_view TextOf(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace fuzz
