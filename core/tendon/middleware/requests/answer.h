#pragma once

#include <tendon/middleware/frame.h>

#include <cassert>
#include <memory>
#include <span>
#include <utility>

namespace tendon {

/// The body of an answer: in memory of its own, or in memory that somebody lends, so that a large
/// one need not be copied to whoever waits for it.
class Answer {
 public:
  explicit Answer(Bytes own) : own_(std::move(own)) {}
  /// `body` lies there as long as anybody holds `owner`, which is not null.
  Answer(std::span<const std::byte> body, std::shared_ptr<const void> owner)
      : lent_(body), owner_(std::move(owner)) {
    assert(owner_);
  }

  /// Valid as long as this is neither moved nor destroyed.
  [[nodiscard]] std::span<const std::byte> body() const {
    return owner_ ? lent_ : std::span<const std::byte>(own_);
  }
  /// Copies what is lent.
  [[nodiscard]] Bytes TakeBytes() && {
    return owner_ ? Bytes(lent_.begin(), lent_.end()) : std::move(own_);
  }

 private:
  Bytes own_;
  std::span<const std::byte> lent_;
  std::shared_ptr<const void> owner_;
};

}  // namespace tendon
