#pragma once

#include <tendon/middleware/frame.h>

#include <cassert>
#include <memory>
#include <span>
#include <utility>

namespace tendon {

/// The body of an answer, in its own memory or in memory of another object, so that a large answer
/// need not be copied.
class Answer {
 public:
  explicit Answer(Bytes own) : own_(std::move(own)) {}
  /// `body` is valid as long as `owner` is held; `owner` is not null.
  Answer(std::span<const std::byte> body, std::shared_ptr<const void> owner)
      : lent_(body), owner_(std::move(owner)) {
    assert(owner_);
  }

  /// Valid until this object is moved or destroyed.
  [[nodiscard]] std::span<const std::byte> body() const {
    return owner_ ? lent_ : std::span<const std::byte>(own_);
  }
  /// Copies the body if it is in memory of another object.
  [[nodiscard]] Bytes TakeBytes() && {
    return owner_ ? Bytes(lent_.begin(), lent_.end()) : std::move(own_);
  }

 private:
  Bytes own_;
  std::span<const std::byte> lent_;
  std::shared_ptr<const void> owner_;
};

}  // namespace tendon
