#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/recording/recording_entry.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

namespace tendon::recording {

/// The times of an entry on this process's steady clock.
struct EntryTimes {
  SteadyTime first;
  SteadyTime last;
};
/// Adding `wall_minus_steady`, in ns, to a steady time gives the wall time. It converts the times
/// of log records, which are wall times.
[[nodiscard]] EntryTimes TimesOf(const RecordingEntry& entry, std::int64_t wall_minus_steady);

/// Removes the rows before `from` and the rows after `to`. Returns false if the entry becomes
/// empty. Does not change entries with changes of the catalogue.
[[nodiscard]] bool Trim(RecordingEntry& entry, SteadyTime from, SteadyTime to,
                        std::int64_t wall_minus_steady);

/// Returns the rows that were lost before the rows of an entry; none if the entry has no rows.
[[nodiscard]] LostRows LostBefore(const RecordingEntry& entry);

/// The entries of the last seconds, while a recorder waits for its condition to start. Both the age
/// and the bytes of the entries are limited. An entry that is dropped because of the limit of bytes
/// counts as missing; an entry that is dropped because of its age does not.
///
/// Thread safety: one thread at a time; the recorder's writing thread uses it. Cost: an entry is
/// moved in and out, and never copied.
class PreTriggerBuffer {
 public:
  PreTriggerBuffer(std::chrono::nanoseconds age, std::size_t most_bytes,
                   std::int64_t wall_minus_steady)
      : age_(age), most_bytes_(most_bytes), wall_minus_steady_(wall_minus_steady) {}

  /// Adds an entry, and drops the oldest ones. `now` does not go backwards.
  void Add(RecordingEntry entry, SteadyTime now);
  /// Removes and returns all entries since `from`. The first entry is the catalogue of that time.
  std::deque<RecordingEntry> TakeSince(SteadyTime from);

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// For each table: the rows that were lost before the entries that TakeSince() has returned.
  [[nodiscard]] const std::map<std::string, LostRows>& losses() const { return losses_; }
  /// Returns how many entries since `from` were dropped because of the limit of bytes. Dropped rows
  /// count as lost by the recorder.
  [[nodiscard]] Losses MissingSince(SteadyTime from) const;
  /// For each table: the rows that were lost before the rows that MissingSince() counts.
  [[nodiscard]] std::map<std::string, LostRows> LostBeforeMissingSince(SteadyTime from) const;

 private:
  struct StoredEntry {
    RecordingEntry entry;
    std::size_t size = 0;
    SteadyTime last;
  };
  struct MissingRows {
    std::uint64_t rows = 0;
    std::uint64_t others = 0;
    LostRows lost_before;
  };
  /// Counts entries that were dropped because of the limit of bytes. Entries whose times differ by
  /// less than a thousandth of the age are counted together.
  struct DroppedSpan {
    SteadyTime first;
    SteadyTime last;
    // The key is the path of the table or event, and empty for log records.
    std::map<std::string, MissingRows> by_path;
  };

  void DropOldest(bool is_too_old);
  void CountLoss(const RecordingEntry& entry, const LostRows& lost);
  void ForgetDroppedBefore(SteadyTime from);
  void NoteDropped(const StoredEntry& kept);

  const std::chrono::nanoseconds age_;
  const std::size_t most_bytes_;
  const std::int64_t wall_minus_steady_;
  std::deque<StoredEntry> entries_;
  std::size_t bytes_ = 0;
  std::deque<DroppedSpan> dropped_;
  std::map<std::string, LostRows> losses_;
  Catalogue catalogue_;  // as it was before the first entry
  bool has_catalogue_ = false;
};

}  // namespace tendon::recording
