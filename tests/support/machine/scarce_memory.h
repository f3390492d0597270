#pragma once

#include <cstddef>

namespace tendon {

/// While this object lives, `operator new` throws in the whole process for requests of this size or
/// more. One at a time.
class ScarceMemory {
 public:
  explicit ScarceMemory(std::size_t too_much) noexcept;
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;
  ~ScarceMemory();
};

}  // namespace tendon
