#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace tendon {

class HistoryRing;

/// The memory that all rings of one process share. Memory is taken when it is needed, and never
/// exceeds the limit.
///
/// When the memory is used up, the ring with the most bytes loses its oldest records. Therefore, a
/// ring that needs little memory keeps all its records, and the other rings have equal shares of
/// the rest.
///
/// Thread safety: one thread at a time, together with the rings.
class HistoryMemory {
 public:
  explicit HistoryMemory(std::size_t limit) : limit_(limit) {}
  HistoryMemory(const HistoryMemory&) = delete;
  HistoryMemory& operator=(const HistoryMemory&) = delete;

  [[nodiscard]] std::size_t limit() const { return limit_; }
  [[nodiscard]] std::size_t used() const { return used_; }

  /// Takes memory that is not part of a ring. If necessary, rings lose their oldest records to
  /// provide it. Returns false, and takes nothing, if more than a quarter of the memory would be
  /// used in this way.
  bool Reserve(std::size_t bytes);
  void Release(std::size_t bytes);

 private:
  friend class HistoryRing;

  /// Takes memory for `ring`. If `ring` is null, takes memory that is not part of a ring. Returns
  /// false if the share of the ring is too small.
  bool Take(HistoryRing* ring, std::size_t bytes);
  /// Returns an eighth of the minimum share of a ring, in bytes.
  [[nodiscard]] std::size_t UsefulChunk() const { return limit_ / (8 * rings_.size()); }

  const std::size_t limit_;
  std::size_t used_ = 0;
  std::size_t reserved_ = 0;
  std::vector<HistoryRing*> rings_;
};

/// A row, an event or a log record. `body` is valid until the ring is changed.
struct HistoryRecord {
  std::uint64_t number = 0;  ///< the position in its series
  std::int64_t time = 0;     ///< ns on the steady clock of this process
  std::uint32_t tag = 0;     ///< has a meaning only for the user of the ring
  std::span<const std::byte> body;
};

/// Keeps the newest records of one series, such as the rows of a table. Numbers and times only
/// grow. A missing number is a record that was lost. The memory consists of chunks, which are
/// larger for fast series, and which are freed as a whole.
///
/// Thread safety: one thread at a time. The memory must outlive the ring.
class HistoryRing {
 public:
  static constexpr std::size_t kSmallestChunk = std::size_t{1} << 10U;
  static constexpr std::size_t kLargestChunk = std::size_t{64} << 10U;

  /// Records older than `span` need not be kept.
  HistoryRing(HistoryMemory& memory, std::chrono::nanoseconds span);
  HistoryRing(const HistoryRing&) = delete;
  HistoryRing& operator=(const HistoryRing&) = delete;
  ~HistoryRing();

  /// Adds a copy of the record. If there is no memory for the copy, counts the record as dropped
  /// and returns false.
  bool Append(const HistoryRecord& record);
  /// Counts a record of this time as dropped, instead of Append().
  void CountDropped(std::int64_t time);
  /// Frees chunks whose records are all older than `time`.
  void DropBefore(std::int64_t time);

  [[nodiscard]] bool empty() const { return chunks_.empty(); }
  /// The memory of the chunks, bytes.
  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// The number of records that were dropped because of the memory.
  [[nodiscard]] std::uint64_t dropped() const { return dropped_; }
  /// Returns the time of the newest record that was dropped because of the memory. Returns nullopt
  /// if none was dropped. All later records are kept.
  [[nodiscard]] std::optional<std::int64_t> last_dropped() const { return last_dropped_; }

  /// Reads records in order. Valid until the ring is changed.
  class Cursor {
   public:
    /// Returns nullopt at the end.
    std::optional<HistoryRecord> Next();

   private:
    friend class HistoryRing;
    Cursor(const HistoryRing& ring, std::size_t chunk) : ring_(&ring), chunk_(chunk) {}

    const HistoryRing* ring_;
    std::size_t chunk_;
    std::size_t position_ = 0;  // in the chunk, bytes
    std::uint64_t record_ = 0;  // in the chunk
  };
  /// Returns a cursor that begins with the first record whose number is at least `number`.
  [[nodiscard]] Cursor From(std::uint64_t number) const;
  /// Returns a cursor that begins with the first record that is not older than `time`.
  [[nodiscard]] Cursor Since(std::int64_t time) const;

 private:
  friend class HistoryMemory;

  /// Records with consecutive numbers.
  struct Chunk {
    std::unique_ptr<std::byte[]> bytes;
    std::size_t capacity = 0;
    std::size_t used = 0;
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    std::int64_t first_time = 0;
    std::int64_t last_time = 0;
  };

  bool AddChunk(const HistoryRecord& record, std::size_t needed);
  [[nodiscard]] std::size_t ChunkSizeFor(std::size_t needed);
  /// Frees the oldest chunk because of the memory. Returns false if there is none.
  bool DropOldest();
  void RemoveFront();

  HistoryMemory& memory_;
  const std::chrono::nanoseconds span_;
  std::deque<Chunk> chunks_;
  std::size_t bytes_ = 0;
  std::size_t next_size_ = kSmallestChunk;
  std::uint64_t dropped_ = 0;
  std::optional<std::int64_t> last_dropped_;
};

}  // namespace tendon
