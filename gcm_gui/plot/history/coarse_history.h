#pragma once

#include <gcm_gui/plot/series/sample_ring.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>

namespace tendon::gui {

/// A signal as it is remembered when there is no room for its samples any more: the lowest and the
/// highest value of each 100 ms. One thread.
class CoarseHistory {
 public:
  static constexpr std::int64_t kWidthNs = 100'000'000;

  struct Bucket {
    std::int64_t from_ns = 0;  ///< a multiple of kWidthNs
    std::uint64_t low = 0;     ///< word of kind()
    std::uint64_t high = 0;    ///< the same
  };
  static constexpr std::size_t kBytesPerBucket = sizeof(Bucket);

  /// O(samples). Values that are not finite are left out. A clock that was set back by more than a
  /// second makes it start over, and so do numbers of another kind.
  void append(std::span<const Sample> samples);
  /// At most so many buckets; the oldest ones go.
  void setLimit(std::size_t buckets);
  /// Oldest first.
  [[nodiscard]] const std::deque<Bucket>& buckets() const { return buckets_; }
  [[nodiscard]] ExactNumber::Kind kind() const { return kind_; }
  [[nodiscard]] std::size_t bytes() const { return buckets_.size() * kBytesPerBucket; }

 private:
  std::deque<Bucket> buckets_;
  ExactNumber::Kind kind_ = ExactNumber::Kind::kReal;
  std::size_t limit_ = 1 << 16;
};

}  // namespace tendon::gui
