#pragma once

#include <core/seeded/seeded_atomics.h>

#include <string>
#include <utility>

/// The kinds of faults. Each changes one step of a class.
namespace tendon::seeded {

constexpr std::size_t kAnyThread = 0;

inline bool IsBy(const Access& access, std::size_t thread) {
  return thread == kAnyThread || access.thread == thread;
}

/// Makes a load, store or change of one atomic relaxed.
inline Fault Relaxed(std::string name, Step step, MemoryModel::Location location,
                     std::size_t thread = kAnyThread) {
  return {std::move(name),
          [=](Access& access) {
            if (access.step == step && access.location == location && IsBy(access, thread)) {
              access.order = std::memory_order_relaxed;
            }
          },
          {}};
}

inline Fault WithoutFence(std::string name, std::memory_order order,
                          std::size_t thread = kAnyThread) {
  return {std::move(name),
          [=](Access& access) {
            if (access.step == Step::kFence && access.order == order && IsBy(access, thread)) {
              access.is_left_out = true;
            }
          },
          {}};
}

/// Omits one fence: the fence with index `number` of the thread.
inline Fault WithoutOneFence(std::string name, std::size_t thread, std::size_t number) {
  return {std::move(name),
          [=](Access& access) {
            if (access.step == Step::kFence && access.fences == number && IsBy(access, thread)) {
              access.is_left_out = true;
            }
          },
          {}};
}

inline Fault WithoutBarrier(std::string name) {
  return {std::move(name),
          [](Access& access) {
            if (access.step == Step::kProcessBarrier) access.is_left_out = true;
          },
          {}};
}

/// Disables the check of a value that `thread` loads from `location`. The value is replaced by
/// `forge(value)`, with which the check always passes.
template <typename Change>
Fault WithoutCheck(std::string name, MemoryModel::Location location, std::size_t thread,
                   Change forge) {
  return {std::move(name), {}, [=](const Access& access, std::uint64_t& value) {
            if (access.location == location && access.thread == thread) value = forge(value);
          }};
}

/// Disables the check of the first load after a fence, from any location.
inline Fault WithoutCheckAfterFence(std::string name, std::size_t thread, std::uint64_t forged) {
  return {std::move(name), {}, [=](const Access& access, std::uint64_t& value) {
            if (access.loads_since_fence == 0 && access.thread == thread) value = forged;
          }};
}

inline Fault None() { return {"None", {}, {}}; }

struct NameOf {
  template <typename Info>
  std::string operator()(const Info& info) const {
    return info.param.name;
  }
};

}  // namespace tendon::seeded
