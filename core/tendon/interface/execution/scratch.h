#pragma once

#include <tendon/lockfree/try_lock.h>

#include <optional>

namespace tendon {

/// A buffer that the calls of one command reuse one after another, so that it keeps its memory. A
/// call that finds it in use gets a temporary object. A copied Scratch starts with a new object.
template <typename T>
class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch& /*other*/) {}
  Scratch& operator=(const Scratch&) = delete;

  /// Borrows the object for one call, or has its own if another call has borrowed it.
  class Use {
   public:
    explicit Use(Scratch& scratch) : hold_(scratch.lease_), kept_(scratch.kept_) {
      if (!hold_) own_.emplace();
    }

    [[nodiscard]] T& operator*() { return hold_ ? kept_ : *own_; }
    [[nodiscard]] T* operator->() { return &**this; }

   private:
    TryLock<>::Hold hold_;
    T& kept_;
    std::optional<T> own_;
  };

 private:
  TryLock<> lease_;
  T kept_{};
};

}  // namespace tendon
