#pragma once

#include <tendon/lockfree/lease.h>

#include <optional>

namespace tendon {

/// An object that the calls of one command use one after the other, so that it keeps what it has
/// allocated. A call that finds another one at it gets an object of its own. A copy is a new one.
template <typename T>
class Scratch {
 public:
  Scratch() = default;
  Scratch(const Scratch& /*other*/) {}
  Scratch& operator=(const Scratch&) = delete;

  /// Borrows the object for one call; has one of its own where another call borrows it.
  class Use {
   public:
    explicit Use(Scratch& scratch) : hold_(scratch.lease_), kept_(scratch.kept_) {
      if (!hold_) own_.emplace();
    }

    [[nodiscard]] T& operator*() { return hold_ ? kept_ : *own_; }
    [[nodiscard]] T* operator->() { return &**this; }

   private:
    Lease<>::Hold hold_;
    T& kept_;
    std::optional<T> own_;
  };

 private:
  Lease<> lease_;
  T kept_{};
};

}  // namespace tendon
