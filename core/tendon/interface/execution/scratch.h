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
    explicit Use(Scratch& scratch) : scratch_(scratch), is_leased_(scratch.lease_.TryTake()) {
      if (!is_leased_) own_.emplace();
    }
    ~Use() {
      if (is_leased_) scratch_.lease_.Return();
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    [[nodiscard]] T& operator*() { return is_leased_ ? scratch_.kept_ : *own_; }
    [[nodiscard]] T* operator->() { return &**this; }

   private:
    Scratch& scratch_;
    bool is_leased_;
    std::optional<T> own_;
  };

 private:
  Lease<> lease_;
  T kept_{};
};

}  // namespace tendon
