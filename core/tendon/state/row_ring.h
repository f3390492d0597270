#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace tendon {

/// The outcome of an attempt to read one row.
enum class RowResult : std::uint8_t {
  kDone,
  kNotYet,     ///< not written yet
  kOvertaken,  ///< the writer has overwritten the row
  kAbsent,     ///< the row exists, but its value did not fit into the column
  kInvalid,    ///< the row exists, but its value is invalid for its type
};

/// The lock-free part of a state table: a ring of rows of 64-bit words. Each row has a number,
/// called its tick, and a time.
///
/// Thread safety: one thread writes (Begin, Store, Publish) and never waits; any number of threads
/// read. All words are atomic: if the writer overwrites a row during a read, the reader copies a
/// mixture of two rows, without undefined behaviour, and detects it:
/// - The writer stores the new tick of a row before it changes any other word of it.
/// - The reader checks the row's tick after it has copied all the words it wants. If any of these
///   words was of a later row, the fences guarantee that the reader sees the tick of that row.
template <typename Atomics = StdAtomics>
class RowRing {
 public:
  using Word = typename Atomics::template Atomic<std::uint64_t>;

  /// Allocates memory for at least `rows` rows of `row_words` words, and touches all of it. The
  /// number of rows is rounded up to a power of two that is greater than `rows`, because one row is
  /// always being replaced. Call it only before the first row. If there is not enough memory,
  /// throws std::bad_alloc and leaves the ring unchanged.
  void Allocate(std::size_t rows, std::size_t row_words) {
    assert(is_empty());
    const std::size_t count = std::bit_ceil(rows + 1);
    const std::size_t stride = StrideFor(row_words);
    const std::size_t words = count * stride;
    memory_ = std::make_unique<Word[]>(words + kLineWords);
    mask_ = count - 1;
    stride_ = stride;
    row_words_ = row_words;
    std::size_t space = (words + kLineWords) * sizeof(Word);
    void* first = memory_.get();
    rows_ = static_cast<Word*>(std::align(kCacheLine, words * sizeof(Word), first, space));
  }
  /// Gives the first row this tick instead of 0. Call it only before the first row.
  void SetFirstTick(std::uint64_t tick) noexcept {
    first_ = tick;
    next_.store(tick, std::memory_order_relaxed);
  }
  /// Returns how many rows fit into `words` words, but at least 1.
  [[nodiscard]] static std::size_t RowsWithin(std::size_t words, std::size_t row_words) noexcept {
    const std::size_t fit = words / StrideFor(row_words);
    return fit < 2 ? 1 : std::bit_floor(fit) - 1;
  }

  /// Writer: starts the next row.
  void Begin(std::int64_t time) noexcept { BeginAt(next_.load(std::memory_order_relaxed), time); }
  /// Writer: like Begin(), but skips the ticks before `tick`. Reads of a skipped tick return
  /// kOvertaken, because its place in the ring holds another tick. The first row cannot skip ticks.
  void BeginAt(std::uint64_t tick, std::int64_t time) noexcept {
    assert(tick >= first_);
    tick_ = tick;
    row_ = Row(tick);
    row_[kTick].store(tick, std::memory_order_relaxed);
    Atomics::Fence(std::memory_order_release);  // (A) the tick is stored before other words
    row_[kTime].store(static_cast<std::uint64_t>(time), std::memory_order_relaxed);
  }

  /// Writer: sets words of the row, starting at `offset`.
  void Store(std::size_t offset, std::span<const std::uint64_t> words) noexcept {
    assert(offset + words.size() <= row_words_);
    Word* const target = row_ + kHeaderWords + offset;
    for (std::size_t i = 0; i < words.size(); ++i) {
      target[i].store(words[i], std::memory_order_relaxed);
    }
  }

  /// Writer: makes the row the newest.
  void Publish() noexcept {
    next_.store(tick_ + 1, std::memory_order_release);  // (B) publishes the row
  }

  /// The tick of the next row. It is the number of rows ever written, unless ticks were skipped.
  [[nodiscard]] std::uint64_t next_tick() const noexcept {
    return next_.load(std::memory_order_acquire);  // pairs with (B)
  }
  [[nodiscard]] bool is_empty() const noexcept { return next_tick() == first_; }
  /// The tick of the oldest row that can be read until the writer begins another row.
  [[nodiscard]] std::uint64_t oldest_tick() const noexcept {
    const std::uint64_t next = next_tick();
    return next - first_ > mask_ ? next - mask_ : first_;
  }

  /// Reader: calls `copy(words)`, which must copy words of a row with relaxed loads only. Returns
  /// kDone if all copied words belong to that row.
  template <typename Copy>
  RowResult Read(std::uint64_t tick, Copy copy) const {
    if (tick < first_) return RowResult::kOvertaken;
    return tick < next_tick() ? ReadWritten(tick, copy) : RowResult::kNotYet;
  }

  /// Reader: like Read(), but for the newest row, whose tick it stores in `tick`. Returns kNotYet
  /// before the first row. Tries again only if the writer overwrites the whole ring during the
  /// read.
  template <typename Copy>
  RowResult ReadNewest(std::uint64_t& tick, Copy copy) const {
    while (true) {
      const std::uint64_t next = next_tick();
      if (next == first_) return RowResult::kNotYet;
      tick = next - 1;
      if (ReadWritten(tick, copy) == RowResult::kDone) return RowResult::kDone;
    }
  }

  /// Reader: reads the time of a row.
  RowResult ReadTime(std::uint64_t tick, std::int64_t& time) const noexcept {
    return Read(tick, [&](const Word* words) { time = TimeOf(words); });
  }

  /// Reader: finds the newest row that is not later than `time`. Returns kNotYet if all rows are
  /// later, and kOvertaken if such a row may have existed but is overwritten.
  RowResult Find(std::int64_t time, std::uint64_t& tick) const noexcept {
    std::uint64_t low = oldest_tick();
    std::uint64_t high = next_tick();
    if (high == first_) return RowResult::kNotYet;
    bool is_found = false;
    while (low < high) {  // rows before `low` are lost, or not later than `time`; rows from `high`
                          // on are later than `time`
      const std::uint64_t middle = low + (high - low) / 2;
      std::int64_t its_time = 0;
      const bool is_lost = ReadTime(middle, its_time) != RowResult::kDone;
      const bool is_later = !is_lost && its_time > time;
      (is_later ? high : low) = is_later ? middle : middle + 1;
      if (!is_later) is_found = !is_lost;
    }
    if (is_found) tick = low - 1;
    return is_found ? RowResult::kDone : low == first_ ? RowResult::kNotYet : RowResult::kOvertaken;
  }

  /// For use in `copy`: returns the time of the row whose words are given.
  static std::int64_t TimeOf(const Word* words) noexcept {
    return static_cast<std::int64_t>((words - kHeaderWords)[kTime].load(std::memory_order_relaxed));
  }

 private:
  static constexpr std::size_t kTick = 0;
  static constexpr std::size_t kTime = 1;
  static constexpr std::size_t kHeaderWords = 2;
  static constexpr std::size_t kLineWords = kCacheLine / sizeof(std::uint64_t);

  static std::size_t StrideFor(std::size_t row_words) noexcept {
    return (kHeaderWords + row_words + kLineWords - 1) / kLineWords * kLineWords;
  }

  [[nodiscard]] Word* Row(std::uint64_t tick) const noexcept {
    return rows_ + (tick & mask_) * stride_;
  }

  template <typename Copy>
  RowResult ReadWritten(std::uint64_t tick, Copy& copy) const {
    const Word* const row = Row(tick);
    copy(row + kHeaderWords);
    // Pairs with (A): the tick is loaded after the words.
    Atomics::Fence(std::memory_order_acquire);
    return row[kTick].load(std::memory_order_relaxed) == tick ? RowResult::kDone
                                                              : RowResult::kOvertaken;
  }

  std::unique_ptr<Word[]> memory_;
  Word* rows_ = nullptr;
  std::size_t mask_ = 0;
  std::size_t stride_ = 0;
  std::size_t row_words_ = 0;
  std::uint64_t first_ = 0;
  Word* row_ = nullptr;     // the row that the writer has begun
  std::uint64_t tick_ = 0;  // the tick of row_; used by the writer
  alignas(kSeparation) Word next_{0};
};

}  // namespace tendon
