#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon {

/// The handles that one end of a channel issues: one number for each object, followed by one number
/// for each member of the object. This class checks the handles in received messages. Numbers are
/// never reused. Thread-safe.
template <typename T>
class HandleTable {
 public:
  /// Issues the numbers for an object that does not exist yet, and returns the first one.
  std::uint32_t Reserve(std::size_t members) {
    const std::scoped_lock lock(mutex_);
    const std::uint32_t handle = next_;
    next_ += 1 + static_cast<std::uint32_t>(members);
    entries_[handle] = {.last = next_ - 1, .object = nullptr};
    return handle;
  }

  /// Sets the object of a number. Does nothing if the number has been removed.
  void Put(std::uint32_t handle, std::shared_ptr<T> object) {
    const std::scoped_lock lock(mutex_);
    const auto found = entries_.find(handle);
    if (found != entries_.end()) found->second.object = std::move(object);
  }

  void Remove(std::uint32_t handle) {
    std::shared_ptr<T> removed;  // destroyed after the lock is released
    const std::scoped_lock lock(mutex_);
    const auto found = entries_.find(handle);
    if (found == entries_.end()) return;
    removed = std::move(found->second.object);
    entries_.erase(found);
  }

  /// The object or member to which a number refers.
  struct Lookup {
    std::shared_ptr<T> object;  ///< null if the number was not issued
    std::size_t offset = 0;     ///< 0 for the object itself, i + 1 for its member i
  };
  [[nodiscard]] Lookup Find(std::uint32_t handle) const {
    const std::scoped_lock lock(mutex_);
    auto after = entries_.upper_bound(handle);
    if (after == entries_.begin()) return {};
    const auto& [first, entry] = *--after;
    if (handle > entry.last) return {};
    return {entry.object, handle - first};
  }

  [[nodiscard]] std::vector<std::shared_ptr<T>> objects() const {
    const std::scoped_lock lock(mutex_);
    std::vector<std::shared_ptr<T>> all;
    for (const auto& [handle, entry] : entries_) {
      if (entry.object) all.push_back(entry.object);
    }
    return all;
  }

 private:
  struct Entry {
    std::uint32_t last = 0;
    std::shared_ptr<T> object;
  };

  mutable std::mutex mutex_;
  std::uint32_t next_ = 1;
  std::map<std::uint32_t, Entry> entries_;
};

}  // namespace tendon
