#include <tendon/recording/pre_trigger_buffer.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace tendon::recording {
namespace {

SteadyTime TimeOfRow(const RowsEntry& rows, std::size_t row) {
  return SteadyTime(std::chrono::nanoseconds(rows.times[row]) - rows.clock_offset);
}

SteadyTime TimeOfRecord(const LogEntry& entry, std::int64_t wall_minus_steady) {
  return SteadyTime(std::chrono::nanoseconds(entry.record.time - wall_minus_steady));
}

/// Keeps the rows from `begin` up to, but not including, `end`.
void KeepRows(RowsEntry& rows, std::size_t begin, std::size_t end) {
  const std::size_t width = rows.source->members.size();
  const auto bytes_of = [&](std::size_t first, std::size_t last) {
    std::size_t bytes = 0;
    for (std::size_t i = first * width; i < last * width; ++i) bytes += rows.cell_sizes[i];
    return static_cast<std::ptrdiff_t>(bytes);
  };
  const auto keep = [](auto& list, std::size_t first, std::size_t last) {
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(last), list.end());
    list.erase(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(first));
  };
  const std::ptrdiff_t before = bytes_of(0, begin);
  const std::ptrdiff_t kept = bytes_of(begin, end);
  rows.cells.erase(rows.cells.begin() + before + kept, rows.cells.end());
  rows.cells.erase(rows.cells.begin(), rows.cells.begin() + before);
  keep(rows.cell_sizes, begin * width, end * width);
  keep(rows.ticks, begin, end);
  keep(rows.times, begin, end);
  if (begin > 0) rows.lost_before = {};  // these rows were lost before the removed rows
}

}  // namespace

EntryTimes TimesOf(const RecordingEntry& entry, std::int64_t wall_minus_steady) {
  if (const auto* rows = std::get_if<RowsEntry>(&entry)) {
    return {TimeOfRow(*rows, 0), TimeOfRow(*rows, rows->times.size() - 1)};
  }
  if (const auto* event = std::get_if<EventEntry>(&entry)) return {event->raised, event->raised};
  if (const auto* record = std::get_if<LogEntry>(&entry)) {
    const SteadyTime time = TimeOfRecord(*record, wall_minus_steady);
    return {time, time};
  }
  const SteadyTime received = std::get<CatalogueEntry>(entry).received;
  return {received, received};
}

bool Trim(RecordingEntry& entry, SteadyTime from, SteadyTime to, std::int64_t wall_minus_steady) {
  if (std::holds_alternative<CatalogueEntry>(entry)) return true;
  const EntryTimes times = TimesOf(entry, wall_minus_steady);
  if (times.last < from || times.first > to) return false;
  if (times.first >= from && times.last <= to) return true;
  RowsEntry& rows = std::get<RowsEntry>(entry);
  std::size_t begin = 0;
  while (TimeOfRow(rows, begin) < from) ++begin;
  std::size_t end = rows.times.size();
  while (end > begin && TimeOfRow(rows, end - 1) > to) --end;
  KeepRows(rows, begin, end);
  return end > begin;
}

LostRows LostBefore(const RecordingEntry& entry) {
  const auto* rows = std::get_if<RowsEntry>(&entry);
  return rows == nullptr ? LostRows() : rows->lost_before;
}

void PreTriggerBuffer::Add(RecordingEntry entry, SteadyTime now) {
  // The longest delay until the recorder knows that a trigger has fired.
  constexpr std::chrono::seconds kLatest(1);
  const std::size_t size = SizeOf(entry);
  const SteadyTime last = TimesOf(entry, wall_minus_steady_).last;
  entries_.push_back({std::move(entry), size, last});
  bytes_ += size;
  const SteadyTime oldest = now - age_ - kLatest;
  while (!entries_.empty() && entries_.front().last < oldest) DropOldest(true);
  while (entries_.size() > 1 && bytes_ > most_bytes_) DropOldest(false);
  ForgetDroppedBefore(oldest);
}

void PreTriggerBuffer::ForgetDroppedBefore(SteadyTime from) {
  std::erase_if(dropped_, [&](const DroppedSpan& dropped) {
    if (dropped.last >= from) return false;
    for (const auto& [path, one] : dropped.by_path) {
      if (one.lost_before.all() > 0) losses_[path] += one.lost_before;
    }
    return true;
  });
}

void PreTriggerBuffer::NoteDropped(const StoredEntry& kept) {
  constexpr int kParts = 1000;
  constexpr std::chrono::nanoseconds kShortest = std::chrono::milliseconds(1);
  const auto part = std::max(kShortest, age_ / kParts);
  if (dropped_.empty() || kept.last - dropped_.back().first > part) {
    dropped_.push_back({kept.last, kept.last, {}});
  }
  DroppedSpan& now = dropped_.back();
  now.last = std::max(now.last, kept.last);
  MissingRows& missing = now.by_path[PathOf(kept.entry)];
  const auto* rows = std::get_if<RowsEntry>(&kept.entry);
  missing.rows += rows != nullptr ? rows->ticks.size() : 0U;
  missing.others += rows != nullptr ? 0U : 1U;
  missing.lost_before += LostBefore(kept.entry);
}

void PreTriggerBuffer::DropOldest(bool is_too_old) {
  const StoredEntry& oldest = entries_.front();
  if (is_too_old) CountLoss(oldest.entry, LostBefore(oldest.entry));
  if (const auto* changes = std::get_if<CatalogueEntry>(&oldest.entry)) {
    if (changes->is_snapshot && !changes->changes.empty()) {
      catalogue_ = Catalogue::At(changes->changes.back().revision - changes->changes.size());
    }
    for (const CatalogueChange& change : changes->changes) (void)catalogue_.Apply(change);
    has_catalogue_ = true;
  } else if (!is_too_old) {
    NoteDropped(oldest);
  }
  bytes_ -= oldest.size;
  entries_.pop_front();
}

std::deque<RecordingEntry> PreTriggerBuffer::TakeSince(SteadyTime from) {
  ForgetDroppedBefore(from);
  // All changes of the catalogue are kept, including old ones, so that the file has the whole
  // catalogue.
  std::deque<RecordingEntry> taken;
  if (has_catalogue_) {
    taken.emplace_back(
        CatalogueEntry{.is_snapshot = true, .received = from, .changes = catalogue_.AsChanges()});
  }
  for (StoredEntry& kept : entries_) {
    if (auto* changes = std::get_if<CatalogueEntry>(&kept.entry)) {
      changes->received = std::max(changes->received, from);
    }
    const LostRows lost = LostBefore(kept.entry);
    const bool is_wanted = Trim(kept.entry, from, SteadyTime::max(), wall_minus_steady_);
    if (!is_wanted || LostBefore(kept.entry) != lost) CountLoss(kept.entry, lost);
    if (is_wanted) taken.push_back(std::move(kept.entry));
  }
  entries_.clear();
  bytes_ = 0;
  return taken;
}

void PreTriggerBuffer::CountLoss(const RecordingEntry& entry, const LostRows& lost) {
  if (lost.all() == 0) return;
  losses_[ToString(std::get<RowsEntry>(entry).source->name)] += lost;
}

Losses PreTriggerBuffer::MissingSince(SteadyTime from) const {
  Losses missing;
  for (const DroppedSpan& dropped : dropped_) {
    if (dropped.last < from) continue;
    for (const auto& [path, one] : dropped.by_path) {
      if (one.rows > 0) missing.rows[path].viewer += one.rows;
      if (one.others > 0 && !path.empty()) missing.events[path] += one.others;
      if (one.others > 0 && path.empty()) missing.log += one.others;
    }
  }
  return missing;
}

std::map<std::string, LostRows> PreTriggerBuffer::LostBeforeMissingSince(SteadyTime from) const {
  std::map<std::string, LostRows> lost;
  for (const DroppedSpan& dropped : dropped_) {
    if (dropped.last < from) continue;
    for (const auto& [path, one] : dropped.by_path) {
      if (one.lost_before.all() > 0) lost[path] += one.lost_before;
    }
  }
  return lost;
}

}  // namespace tendon::recording
