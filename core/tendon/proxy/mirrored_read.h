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

/// Holds the newest copy of a value of another process.
///
/// Thread safety: Put() may be called by one thread at a time, all other functions in any thread.
/// Readers do not block; if several newer copies are written during a read, the read is repeated.
class MirroredValue {
 public:
  /// Allocates all memory, for values of at most `capacity` encoded bytes.
  explicit MirroredValue(std::size_t capacity);

  /// Sets the value. `time` is the time when the value was written, on the clock of this process.
  /// An empty body means that the row had no value. If the body is too large, returns false and
  /// keeps the old value.
  bool Put(SteadyTime time, std::span<const std::byte> body);
  /// While disabled, readers get kDisabled instead of the value.
  void SetEnabled(bool enabled) noexcept { is_enabled_.Set(enabled); }
  /// Called when no more copies will arrive. From now on, readers get kNotConnected.
  void End() noexcept { has_ended_.Set(true); }
  [[nodiscard]] bool has_ended() const noexcept { return has_ended_.Get(); }

  /// Reads the value. Fails with kNoSample before the first value, or if the newest row had no
  /// value. Fails with kDisabled while disabled, and with kNotConnected after End(). Allocates
  /// memory only if `body` must grow.
  Status Read(std::vector<std::byte>& body, SteadyTime& time) const;

 private:
  const std::size_t capacity_;
  std::vector<std::uint64_t> words_;  // buffer for Put(); contains size and body
  RowRing<> copies_;
  Flag is_enabled_{true};
  Flag has_ended_{false};
};

/// A read command of another process. It returns the local copy of the value and sends no request.
/// Fails with kNoSample before the first copy, with kDisabled while the command is disabled in the
/// other process, and with kNotConnected when the connection has ended.
class MirroredReadProxy final : public Offer {
 public:
  MirroredReadProxy(MemberDescription description, std::shared_ptr<const MirroredValue> value)
      : Offer(std::move(description)), value_(std::move(value)) {}

  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* mailbox) const override;

 private:
  const std::shared_ptr<const MirroredValue> value_;
};

}  // namespace tendon
