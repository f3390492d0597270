#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/recording/recording_queue.h>

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
/// A log record has a wall time; `wall_minus_steady`, ns, converts it.
[[nodiscard]] EntryTimes TimesOf(const Entry& entry, std::int64_t wall_minus_steady);

/// Removes the rows before `from` and those after `to`. Returns false if nothing of the entry is
/// left. Leaves changes of the catalogue as they are.
[[nodiscard]] bool Trim(Entry& entry, SteadyTime from, SteadyTime to,
                        std::int64_t wall_minus_steady);

/// Returns the rows that were lost before the rows of an entry; none if the entry has no rows.
[[nodiscard]] LostRows LostBefore(const Entry& entry);

/// The entries of the last seconds, while a recorder waits for its condition to start. It is
/// bounded in time and in bytes. Entries that are dropped because of the bytes, and not because of
/// their age, are counted.
///
/// Thread safety: one thread at a time; the recorder's writing thread uses it. Cost: an entry is
/// moved in and out, and never copied.
class PreTriggerBuffer {
 public:
  PreTriggerBuffer(std::chrono::nanoseconds age, std::size_t most_bytes,
                   std::int64_t wall_minus_steady)
      : age_(age), most_bytes_(most_bytes), wall_minus_steady_(wall_minus_steady) {}

  /// Adds an entry, and drops the oldest ones. `now` does not go backwards.
  void Add(Entry entry, SteadyTime now);
  /// Removes and returns all entries since `from`. The first one is the catalogue as it was then.
  std::deque<Entry> TakeSince(SteadyTime from);

  [[nodiscard]] std::size_t bytes() const { return bytes_; }
  /// By table: the rows that were lost before the result of TakeSince().
  [[nodiscard]] const std::map<std::string, LostRows>& losses() const { return losses_; }
  /// Returns the entries that were dropped since `from` because of the bytes. Rows count as lost by
  /// the recorder.
  [[nodiscard]] Losses MissingSince(SteadyTime from) const;
  /// By table: the rows that were lost before the rows which MissingSince() counts.
  [[nodiscard]] std::map<std::string, LostRows> LostBeforeMissingSince(SteadyTime from) const;

 private:
  struct Kept {
    Entry entry;
    std::size_t size = 0;
    SteadyTime last;
  };
  struct Missing {
    std::uint64_t rows = 0;
    std::uint64_t others = 0;
    LostRows lost_before;
  };
  /// What was dropped because of the bytes, of a thousandth of the age.
  struct Dropped {
    SteadyTime first;
    SteadyTime last;
    std::map<std::string, Missing> by_path;  // of the table or event; empty for log records
  };

  void DropOldest(bool is_too_old);
  void CountLoss(const Entry& entry, const LostRows& lost);
  void ForgetDroppedBefore(SteadyTime from);
  void NoteDropped(const Kept& kept);

  const std::chrono::nanoseconds age_;
  const std::size_t most_bytes_;
  const std::int64_t wall_minus_steady_;
  std::deque<Kept> entries_;
  std::size_t bytes_ = 0;
  std::deque<Dropped> dropped_;
  std::map<std::string, LostRows> losses_;
  Catalogue catalogue_;  // before the entries
  bool has_catalogue_ = false;
};

}  // namespace tendon::recording
