#include <tendon/recording/recording_entry.h>

namespace tendon::recording {

std::size_t SizeOf(const RowsEntry& rows) {
  return sizeof rows + rows.cells.size() + 4 * rows.cell_sizes.size() + 16 * rows.ticks.size();
}

std::size_t SizeOf(const EventEntry& event) { return sizeof event + event.value.size(); }

std::size_t SizeOf(const LogEntry& entry) {
  const auto& [time, level, process, source, text] = entry.record;
  return sizeof entry + process.size() + source.size() + text.size();
}

std::size_t SizeOf(const CatalogueEntry& changes) {
  constexpr std::size_t kUsual = 4096;  // a component with its interfaces
  return sizeof changes + kUsual * changes.changes.size();
}

std::size_t SizeOf(const RecordingEntry& entry) {
  return std::visit([](const auto& one) { return SizeOf(one); }, entry);
}

std::string PathOf(const RecordingEntry& entry) {
  if (const auto* rows = std::get_if<RowsEntry>(&entry)) return ToString(rows->source->name);
  const auto* event = std::get_if<EventEntry>(&entry);
  if (event == nullptr) return {};
  return ToString(event->source->name) + "." + event->source->members.at(event->member).name;
}

void Losses::AddUnwritten(const RecordingEntry& entry, std::uint64_t written) {
  if (const auto* one = std::get_if<RowsEntry>(&entry)) {
    if (one->ticks.size() > written) rows[PathOf(entry)].viewer += one->ticks.size() - written;
  } else if (std::holds_alternative<EventEntry>(entry)) {
    ++events[PathOf(entry)];
  } else if (std::holds_alternative<LogEntry>(entry)) {
    ++log;
  }
}

LostRows Losses::all_rows() const {
  LostRows all;
  for (const auto& [path, lost] : rows) all += lost;
  return all;
}

std::uint64_t Losses::all_events() const {
  std::uint64_t all = 0;
  for (const auto& [path, lost] : events) all += lost;
  return all;
}

Losses& Losses::operator+=(const Losses& other) {
  for (const auto& [path, lost] : other.rows) rows[path] += lost;
  for (const auto& [path, lost] : other.events) events[path] += lost;
  log += other.log;
  return *this;
}

}  // namespace tendon::recording
