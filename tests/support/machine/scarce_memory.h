#pragma once

#include <cstddef>

namespace tendon {

/// While one lives nobody in this process gets as much memory as that at once: `operator new`
/// throws. One at a time.
class ScarceMemory {
 public:
  explicit ScarceMemory(std::size_t too_much) noexcept;
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;
  ~ScarceMemory();
};

}  // namespace tendon
