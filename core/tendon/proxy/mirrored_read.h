#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/status.h>
#include <tendon/interface/offer.h>
#include <tendon/lockfree/flag.h>
#include <tendon/state/row_ring.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace tendon {

/// The newest copy of a value of another process.
///
/// Thread safety: one thread at a time calls Put(); any thread may call all other functions.
/// Readers do not wait; a reader tries again if several newer copies are written during its read.
class MirroredValue {
 public:
  /// Allocates everything, for values of at most `capacity` bytes on the wire.
  explicit MirroredValue(std::size_t capacity);

  /// `time` is when the value was written, on our clock. An empty body means that the row had no
  /// value. Returns false and keeps the old value if the body is too large.
  bool Put(SteadyTime time, std::span<const std::byte> body);
  /// While disabled, readers get kDisabled instead of the value.
  void SetEnabled(bool enabled) noexcept { is_enabled_.Set(enabled); }
  /// Ends the copies: from now on, readers get kNotConnected.
  void End() noexcept { has_ended_.Set(true); }
  [[nodiscard]] bool has_ended() const noexcept { return has_ended_.Get(); }

  /// kNoSample before the first value, or if the newest row had none; kDisabled while disabled;
  /// kNotConnected after End(). Allocates only if `body` must grow.
  Status Read(std::vector<std::byte>& body, SteadyTime& time) const;

 private:
  const std::size_t capacity_;
  std::vector<std::uint64_t> words_;  // buffer of Put(): size and body
  RowRing<> copies_;
  Flag is_enabled_{true};
  Flag has_ended_{false};
};

/// Answers a read from the local copy of a value, without asking the peer. kNoSample before the
/// first copy, kDisabled while the command is disabled there, kNotConnected when the peer is gone.
class MirroredReadProxy final : public Offer {
 public:
  MirroredReadProxy(MemberDescription description, std::shared_ptr<const MirroredValue> value)
      : Offer(std::move(description)), value_(std::move(value)) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  const std::shared_ptr<const MirroredValue> value_;
};

}  // namespace tendon
