#include <tendon/recording/recording_queue.h>

#include <tendon/interface/observed_call.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace tendon::recording {
/// The rows of one table.
class RecordingQueue::TableSink final : public RowSink {
 public:
  TableSink(std::shared_ptr<RecordingQueue> queue, const TableSubscription& table)
      : queue_(std::move(queue)),
        name_(table.process, table.component, table.table),
        path_(ToString(name_)),
        columns_(table.columns) {}

  void OnSubscribed(const std::vector<Schema>& columns) override {
    auto now = std::make_shared<EntrySource>();
    now->name = name_;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      now->members.push_back({columns_.at(i), columns[i]});
    }
    const std::scoped_lock lock(queue_->mutex_);
    source_ = std::move(now);
  }

  void OnRows(const RowBatch& batch) override {
    std::shared_ptr<const EntrySource> source;
    {
      const std::scoped_lock lock(queue_->mutex_);
      source = source_;
    }
    std::optional<RowsEntry> rows;
    if (source && batch.count > 0) rows = Copy(batch, source);
    const std::scoped_lock lock(queue_->mutex_);
    LostRows& trailing = queue_->trailing_losses_[path_];
    queue_->losses_.rows[path_] += batch.lost;
    trailing += batch.lost;
    if (batch.count == 0) return;
    if (rows) {
      rows->lost_before = trailing;
      const std::size_t size = SizeOf(*rows);
      if (queue_->Push(std::move(*rows), size)) {
        trailing = {};
        return;
      }
    }
    trailing.viewer += batch.count;
    queue_->losses_.rows[path_].viewer += batch.count;
  }

  void OnStale(const Error& reason) override {
    const std::scoped_lock lock(queue_->mutex_);
    queue_->Notice(reason.message);
  }

 private:
  static RowsEntry Copy(const RowBatch& batch, const std::shared_ptr<const EntrySource>& source) {
    const std::size_t width = source->members.size();
    RowsEntry rows{.source = source,
                   .epoch = batch.epoch,
                   .clock_offset = batch.clock_offset,
                   .clock_uncertainty = batch.clock_uncertainty,
                   .lost_before = {},
                   .ticks = {batch.ticks.begin(), batch.ticks.end()},
                   .times = {batch.times.begin(), batch.times.end()},
                   .cell_sizes = {},
                   .cells = {}};
    rows.cell_sizes.reserve(batch.count * width);
    for (std::size_t row = 0; row < batch.count; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        const auto cell = batch.cell(row, column);
        rows.cell_sizes.push_back(static_cast<std::uint32_t>(cell.size()));
        rows.cells.insert(rows.cells.end(), cell.begin(), cell.end());
      }
    }
    return rows;
  }

  const std::shared_ptr<RecordingQueue> queue_;
  const InterfaceName name_;
  const std::string path_;
  const std::vector<std::string> columns_;
  std::shared_ptr<const EntrySource> source_;
};

/// The events, or the commands, of one interface.
class RecordingQueue::InterfaceSink final : public EventSink {
 public:
  InterfaceSink(std::shared_ptr<RecordingQueue> queue, EventSubscription events,
                std::map<Fingerprint, Schema> types)
      : queue_(std::move(queue)), subscription_(std::move(events)), types_(std::move(types)) {}

  void OnListening(const std::vector<MemberDescription>& events) override {
    auto now = std::make_shared<EntrySource>();
    now->name = subscription_.provided;
    now->are_commands = !subscription_.commands.empty();
    std::vector<bool> is_known;
    for (const MemberDescription& event : events) {
      const auto [value, is_value_known] = TypeOf(event.signature.in);
      const auto [result, is_result_known] = TypeOf(event.signature.out);
      is_known.push_back(is_value_known && (is_result_known || !now->are_commands));
      now->members.push_back(
          {event.name, now->are_commands ? SchemaOfCalls(value, result) : value});
    }
    const std::scoped_lock lock(queue_->mutex_);
    source_ = std::move(now);
    is_known_ = std::move(is_known);
  }

  void OnEvent(std::size_t event, std::span<const std::byte> value,
               const EventTime& time) override {
    const std::scoped_lock lock(queue_->mutex_);
    EventEntry one{source_, event, time.raised, {value.begin(), value.end()}};
    const std::size_t size = SizeOf(one);
    const bool is_known = source_ && event < is_known_.size() && is_known_[event];
    if (!is_known || !queue_->Push(std::move(one), size)) ++queue_->losses_.events[PathOf(event)];
  }

  void OnEventsLost(std::size_t event, std::uint64_t lost) override {
    const std::scoped_lock lock(queue_->mutex_);
    queue_->losses_.events[PathOf(event)] += lost;
  }

  void OnStale(const Error& reason) override {
    const std::scoped_lock lock(queue_->mutex_);
    queue_->Notice(reason.message);
  }

 private:
  /// The type, and whether it is known.
  [[nodiscard]] std::pair<Schema, bool> TypeOf(Fingerprint fingerprint) const {
    const auto type = types_.find(fingerprint);
    if (type != types_.end()) return {type->second, true};
    return {Schema(), fingerprint == Schema().fingerprint()};
  }
  [[nodiscard]] std::string PathOf(std::size_t event) const { return subscription_.path(event); }

  const std::shared_ptr<RecordingQueue> queue_;
  const EventSubscription subscription_;
  const std::map<Fingerprint, Schema> types_;
  std::shared_ptr<const EntrySource> source_;
  std::vector<bool> is_known_;
};

std::shared_ptr<RowSink> RecordingQueue::SinkOf(const TableSubscription& table) {
  return std::make_shared<TableSink>(shared_from_this(), table);
}

std::shared_ptr<EventSink> RecordingQueue::SinkOf(const EventSubscription& events,
                                                  std::map<Fingerprint, Schema> types) {
  return std::make_shared<InterfaceSink>(shared_from_this(), events, std::move(types));
}

std::deque<RecordingEntry> RecordingQueue::Take(std::chrono::nanoseconds timeout) {
  constexpr std::size_t kAtOnce = std::size_t{1} << 20U;  // bytes
  std::unique_lock lock(mutex_);
  arrival_.wait_for(lock, timeout, [this] { return is_woken_ || !entries_.empty(); });
  is_woken_ = false;
  std::deque<RecordingEntry> taken;
  std::size_t size = 0;
  while (!entries_.empty() && size < kAtOnce) {
    size += SizeOf(entries_.front());
    taken.push_back(std::move(entries_.front()));
    entries_.pop_front();
  }
  bytes_ -= size;
  return taken;
}

void RecordingQueue::Wake() {
  const std::scoped_lock lock(mutex_);
  is_woken_ = true;
  arrival_.notify_all();
}

void RecordingQueue::Close() {
  const std::scoped_lock lock(mutex_);
  is_closed_ = true;
  entries_.clear();
  bytes_ = 0;
}

Losses RecordingQueue::losses() const {
  const std::scoped_lock lock(mutex_);
  return losses_;
}

std::map<std::string, LostRows> RecordingQueue::TakeTrailingLosses() {
  const std::scoped_lock lock(mutex_);
  std::map<std::string, LostRows> rest = std::exchange(trailing_losses_, {});
  std::erase_if(rest, [](const auto& one) { return one.second.all() == 0; });
  return rest;
}

std::size_t RecordingQueue::waiting_bytes() const {
  const std::scoped_lock lock(mutex_);
  return bytes_;
}

std::vector<std::string> RecordingQueue::TakeNotices() {
  const std::scoped_lock lock(mutex_);
  return std::exchange(notices_, {});
}

bool RecordingQueue::is_gcm_lost() const {
  const std::scoped_lock lock(mutex_);
  return is_gcm_lost_;
}

bool RecordingQueue::has_past_log() const {
  const std::scoped_lock lock(mutex_);
  return is_log_current_;
}

bool RecordingQueue::needs_snapshot() const {
  const std::scoped_lock lock(mutex_);
  return needs_snapshot_;
}

std::uint64_t RecordingQueue::snapshots() const {
  const std::scoped_lock lock(mutex_);
  return snapshots_;
}

void RecordingQueue::OnSnapshot(const Catalogue& catalogue) {
  CatalogueEntry snapshot{true, SteadyClock().Now(), catalogue.AsChanges()};
  const std::scoped_lock lock(mutex_);
  ++snapshots_;
  if (std::exchange(is_gcm_lost_, false)) Notice("the GCM is available again");
  const std::size_t size = SizeOf(snapshot);
  needs_snapshot_ = !Push(std::move(snapshot), size);
}

void RecordingQueue::OnChanges(const std::vector<CatalogueChange>& changes) {
  CatalogueEntry next{false, SteadyClock().Now(), changes};
  const std::size_t size = SizeOf(next);
  const std::scoped_lock lock(mutex_);
  // Without these changes, later changes cannot be applied.
  if (!needs_snapshot_) needs_snapshot_ = !Push(std::move(next), size);
}

void RecordingQueue::OnGcmLost(const Error& reason) {
  const std::scoped_lock lock(mutex_);
  is_gcm_lost_ = true;
  Notice(reason.message);
}

void RecordingQueue::OnLog(const LogBatch& batch) {
  const std::scoped_lock lock(mutex_);
  if (is_log_current_) losses_.log += batch.lost;
  is_log_current_ |= batch.is_current;
  for (const message::LogRecord& record : batch.records) {
    LogEntry entry{record};
    const std::size_t size = SizeOf(entry);
    if (!Push(std::move(entry), size)) ++losses_.log;
  }
}

/// An entry that is larger than the bound is accepted if it is the only one.
bool RecordingQueue::Push(RecordingEntry entry, std::size_t size) {
  if (is_closed_) return true;
  if (!entries_.empty() && bytes_ + size > most_bytes_) return false;
  entries_.push_back(std::move(entry));
  bytes_ += size;
  if (entries_.size() == 1) arrival_.notify_all();
  return true;
}

void RecordingQueue::Notice(std::string sentence) {
  constexpr std::size_t kMax = 100;
  if (notices_.size() == kMax || std::ranges::count(notices_, sentence) > 0) return;
  notices_.push_back(std::move(sentence));
}

}  // namespace tendon::recording
