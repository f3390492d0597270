#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/status.h>
#include <tendon/lockfree/flag.h>
#include <tendon/state/row_ring.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tendon {

/// The copy of a value of another process, as it has come last.
///
/// Thread safety: one thread at a time puts, any thread reads, turns and ends it. No reader waits;
/// one that is overtaken by several copies tries again.
class MirroredValue {
 public:
  /// Allocates all it needs, for values of at most `capacity` bytes on the wire.
  explicit MirroredValue(std::size_t capacity);

  /// `time`: when it was written, by our clock. An empty body: there was no value. False where it
  /// is too large, which leaves the one before.
  bool Put(SteadyTime time, std::span<const std::byte> body);
  /// Whether it is given to readers.
  void SetEnabled(bool enabled) noexcept { is_enabled_.Set(enabled); }
  /// No newer one comes: the last is not given any more.
  void End() noexcept { has_ended_.Set(true); }
  [[nodiscard]] bool has_ended() const noexcept { return has_ended_.Get(); }

  /// kNoSample before the first, and where there was no value; kDisabled while it is not given;
  /// kNotConnected once it has ended. Allocates where `body` must grow.
  Status Read(std::vector<std::byte>& body, SteadyTime& time) const;

 private:
  const std::size_t capacity_;
  std::vector<std::uint64_t> words_;  // of who puts: the size, and the body
  RowRing<> copies_;
  Flag is_enabled_{true};
  Flag has_ended_{false};
};

}  // namespace tendon
