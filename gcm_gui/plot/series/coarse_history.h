#pragma once

#include <gcm_gui/plot/series/sample_ring.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>

namespace tendon::gui {

/// The older part of a signal, whose samples no longer fit into memory. It keeps the minimum and
/// the maximum of each 100 ms. Use it in one thread only.
class CoarseHistory {
 public:
  static constexpr std::int64_t kWidthNs = 100'000'000;

  struct Bucket {
    std::int64_t from_ns = 0;  ///< a multiple of kWidthNs
    std::uint64_t low = 0;     ///< lowest value, as a word of kind()
    std::uint64_t high = 0;    ///< highest value, as a word of kind()
  };
  static constexpr std::size_t kBytesPerBucket = sizeof(Bucket);

  /// Adds samples. Ignores values that are not finite. Starts again with an empty history if the
  /// clock was set back by more than a second, or if the kind of number changes. O(samples).
  void append(std::span<const Sample> samples);
  void clear() { buckets_.clear(); }
  /// Sets the maximum number of buckets, and drops the oldest ones above it.
  void setLimit(std::size_t buckets);
  /// All buckets, oldest first.
  [[nodiscard]] const std::deque<Bucket>& buckets() const { return buckets_; }
  [[nodiscard]] ExactNumber::Kind kind() const { return kind_; }
  [[nodiscard]] std::size_t bytes() const { return buckets_.size() * kBytesPerBucket; }

 private:
  std::deque<Bucket> buckets_;
  ExactNumber::Kind kind_ = ExactNumber::Kind::kReal;
  std::size_t limit_ = 1 << 16;
};

}  // namespace tendon::gui
