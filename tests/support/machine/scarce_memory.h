#pragma once

#include <cstddef>

namespace tendon {

/// While this object exists, `operator new` throws std::bad_alloc for requests of this size or
/// more, in all threads. Only one object at a time.
class ScarceMemory {
 public:
  explicit ScarceMemory(std::size_t too_much) noexcept;
  ScarceMemory(const ScarceMemory&) = delete;
  ScarceMemory& operator=(const ScarceMemory&) = delete;
  ~ScarceMemory();
};

}  // namespace tendon
