#include <gtest/gtest.h>
#include <support/allocation_guard.h>
#include <support/machine/scarce_memory.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <new>

namespace {

// Constant-initialised, so that the first access in a new thread does not allocate.
constinit thread_local std::uint64_t allocations_of_thread = 0;

constexpr std::size_t kNever = std::numeric_limits<std::size_t>::max();
constinit std::atomic<std::size_t> too_much = kNever;

// Returns null if memory is exhausted.
void* TryAllocate(std::size_t size) noexcept {
  ++allocations_of_thread;
  if (size >= too_much.load(std::memory_order_relaxed)) return nullptr;
  return std::malloc(size == 0 ? 1 : size);
}

void* TryAllocate(std::size_t size, std::align_val_t alignment) noexcept {
  ++allocations_of_thread;
  const auto bytes = static_cast<std::size_t>(alignment);
  return std::aligned_alloc(bytes, (size + bytes - 1) / bytes * bytes);
}

template <typename... Alignment>
void* Allocate(std::size_t size, Alignment... alignment) {
  if (void* memory = TryAllocate(size, alignment...)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return Allocate(size); }
void* operator new[](std::size_t size) { return Allocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return Allocate(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return Allocate(size, alignment);
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return TryAllocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return TryAllocate(size); }
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return TryAllocate(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
  return TryAllocate(size, alignment);
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace tendon {

AllocationGuard::AllocationGuard() noexcept : before_(allocations_of_thread) {}

AllocationGuard::~AllocationGuard() {
  const std::uint64_t count = allocations();
  EXPECT_EQ(count, 0U) << "allocations in this thread while none were allowed";
}

ScarceMemory::ScarceMemory(std::size_t size) noexcept { too_much = size; }

ScarceMemory::~ScarceMemory() { too_much = kNever; }

std::uint64_t AllocationGuard::allocations() const noexcept {
  return allocations_of_thread - before_;
}

}  // namespace tendon
