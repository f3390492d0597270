#pragma once

#include <tendon/lockfree/try_lock.h>

#include <optional>

namespace tendon {

/// A buffer for successive calls of one command. It keeps its memory between the calls. If the
/// buffer is in use, a call gets a temporary object instead. A copied Scratch starts with a new
/// object.
template <typename T>
class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch& /*other*/) {}
  Scratch& operator=(const Scratch&) = delete;

  /// Borrows the object for one call, or creates its own object if another call has borrowed it.
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
