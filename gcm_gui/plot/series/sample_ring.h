#pragma once

#include <gcm_gui/plot/series/exact_number.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

namespace tendon::gui {

/// The clock of a source may be set back by this much between two runs. New samples then get the
/// time of the newest old sample until the clock has passed that time.
inline constexpr std::int64_t kClockToleranceNs = 1'000'000'000;

/// The value of one signal in one row of its state table.
struct Sample {
  /// The time when the row was written, on the steady clock of the source.
  std::int64_t time_ns = 0;
  std::uint64_t tick = 0;  ///< number of the row; the next row has the next number
  ExactNumber value;
};

/// An interruption between two samples, with unknown values.
struct Gap {
  enum class Cause {
    kLost,
    kRestart,
    kStandstill,
    kNoValue,  ///< rows arrived without this element
  };

  Cause cause = Cause::kLost;
  std::uint64_t index = 0;  ///< index of the first sample after the gap
  std::uint64_t tick = 0;   ///< tick of that sample
  std::uint64_t lost = 0;   ///< number of rows that never arrived; 0 for other causes
  std::int64_t from_ns = 0;
  std::int64_t to_ns = 0;
};

/// The latest samples of one signal, oldest first, and the gaps between them.
///
/// The index of a sample counts from the very first sample, and does not change when older samples
/// are dropped. Times never decrease. All numbers are of one kind. Each sample takes 16 bytes;
/// memory grows with the number of samples up to a limit. Use it in one thread only.
class SampleRing {
 public:
  static constexpr std::size_t kBytesPerSample = sizeof(std::int64_t) + sizeof(std::uint64_t);
  static constexpr std::size_t kDefaultLimit = std::size_t{1} << 20;

  /// A contiguous part of the ring.
  struct Segment {
    std::span<const std::int64_t> times;
    std::span<const std::uint64_t> words;  ///< numbers of kind()
  };

  explicit SampleRing(std::size_t limit = kDefaultLimit);

  /// Appends samples, at amortised O(1) per sample. If ticks are missing before a sample, there is
  /// a gap. A sample whose tick is not above the last tick is counted as repeated and dropped. If
  /// the tick of such a sample is lower and its time is later, the source was restarted, and the
  /// sample is kept. A change of the number kind clears the ring. In a ring of integers, NaN means
  /// that the row has no value, and makes a gap.
  void append(std::span<const Sample> samples);
  /// Called when the source was restarted: its ticks start again with the next sample, which comes
  /// after a gap. If the clock of the source was set back, the ring is cleared, because the times
  /// of old and new samples cannot be compared.
  void beginEpoch() { epoch_begins_ = true; }
  /// Called when the source does not run, or did not run for a while. The next sample then comes
  /// after a gap, even if no tick is missing. A sample that follows at once makes no gap, because
  /// it was sent before the source stopped.
  void noteStandstill() { stands_still_ = true; }
  /// Called when the source runs again. The next sample ends the standstill, and the samples after
  /// it follow without a gap.
  void endStandstill() { standstill_ends_ = stands_still_; }
  /// Moves all samples and gaps in time. O(samples).
  void move(std::int64_t by_ns);
  /// Resets the ring to its initial, empty state.
  void clear() { *this = SampleRing(limit_); }
  /// Sets the maximum number of samples, rounded down to a power of two. Drops the oldest samples
  /// above it.
  void setLimit(std::size_t samples);

  [[nodiscard]] std::size_t bytes() const { return times_.size() * kBytesPerSample; }
  [[nodiscard]] std::uint64_t firstIndex() const { return first_; }
  [[nodiscard]] std::uint64_t endIndex() const { return end_; }
  [[nodiscard]] bool empty() const { return first_ == end_; }
  [[nodiscard]] std::int64_t time(std::uint64_t index) const { return times_[index & mask()]; }
  [[nodiscard]] ExactNumber::Kind kind() const { return kind_; }
  [[nodiscard]] ExactNumber number(std::uint64_t index) const {
    return {kind_, words_[index & mask()]};
  }
  /// Returns the nearest double.
  [[nodiscard]] double value(std::uint64_t index) const { return number(index).nearest(); }
  [[nodiscard]] std::uint64_t tick(std::uint64_t index) const;
  /// Returns the index of the first sample at `time_ns` or later; endIndex() if there is none.
  /// O(log n).
  [[nodiscard]] std::uint64_t lowerBound(std::int64_t time_ns) const;
  /// Returns the longest contiguous part of [from, to) that begins at `from`.
  [[nodiscard]] Segment segment(std::uint64_t from, std::uint64_t to) const;
  /// All gaps by index, except those before the oldest sample.
  [[nodiscard]] const std::deque<Gap>& gaps() const { return gaps_; }

  // lost() and repeated() count from the very first sample.
  [[nodiscard]] std::uint64_t lost() const { return lost_; }          ///< rows
  [[nodiscard]] std::uint64_t repeated() const { return repeated_; }  ///< rows

 private:
  [[nodiscard]] std::uint64_t mask() const { return times_.size() - 1; }
  [[nodiscard]] bool continues(const Sample& sample);
  [[nodiscard]] bool takeKind(const Sample& sample);
  void push(std::int64_t time_ns, std::uint64_t word);
  void addGap(Gap::Cause cause, const Sample& next, std::uint64_t lost = 0);
  void forgetUntil(std::uint64_t index);
  void reallocate(std::size_t capacity);

  std::vector<std::int64_t> times_;
  std::vector<std::uint64_t> words_;
  std::deque<Gap> gaps_;
  ExactNumber::Kind kind_ = ExactNumber::Kind::kReal;
  std::size_t limit_;
  std::uint64_t first_ = 0;
  std::uint64_t end_ = 0;
  std::uint64_t base_index_ = 0;  // at or before the oldest sample; no tick is missing after it
  std::uint64_t base_tick_ = 0;   // the tick at base_index_
  std::uint64_t last_tick_ = 0;
  std::uint64_t lost_ = 0;
  std::uint64_t repeated_ = 0;
  bool epoch_begins_ = false;
  bool stands_still_ = false;
  bool standstill_ends_ = false;
  bool has_no_value_ = false;      // a row without a value has arrived after the newest sample
  std::uint64_t lost_before_ = 0;  // rows lost between the newest sample and rows without a value
};

}  // namespace tendon::gui
