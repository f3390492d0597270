#include <tendon/process/history/process_history.h>

#include <tendon/base/os/thread.h>
#include <tendon/payload/codec.h>

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace tendon {
namespace {

using std::chrono::nanoseconds;

constexpr nanoseconds kShortestGap = std::chrono::milliseconds(2);
constexpr nanoseconds kLongestGap = std::chrono::milliseconds(250);
constexpr std::size_t kMaxReplyBytes = std::size_t{128} << 10U;

std::int64_t InNanoseconds(SteadyTime time) { return nanoseconds(time.time_since_epoch()).count(); }

std::int64_t WallMinusSteady() {
  const auto wall = std::chrono::system_clock::now().time_since_epoch();
  return nanoseconds(wall).count() - InNanoseconds(SteadyClock().Now());
}

Result<void> CheckAge(nanoseconds last) {
  if (last.count() >= 0) return {};
  return Error{ErrorCode::kInvalid, "the age must not be below zero"};
}

}  // namespace

ProcessHistory::ProcessHistory(std::string process, HistoryOptions options)
    : process_(std::move(process)),
      options_(options),
      begin_(SteadyClock().Now()),
      memory_(is_on() ? options_.memory : 0),
      log_(memory_, options_.span) {
  if (!is_on()) return;
  log_sink_.emplace([this](LogLevel level, std::string_view source, std::string_view text) {
    log_queue_.Add(level, source, text);
  });
  thread_ = std::thread([this] { Run(); });
}

ProcessHistory::~ProcessHistory() {
  if (!thread_.joinable()) return;
  log_sink_.reset();
  is_stopping_.Set(true);
  wakeup_.Notify();
  thread_.join();
  events_.clear();  // because they call Wake()
}

void ProcessHistory::Add(Component& component) {
  if (!is_on()) return;
  const std::string& name = component.name();
  const std::scoped_lock lock(mutex_);
  try {
    for (const StateTable* table : component.tables()) {
      tables_.push_back(std::make_unique<TableHistory>(name, *table, memory_, options_.span));
    }
    for (const ProvidedDescription& provided : component.provided()) {
      if (provided.events.empty()) continue;
      ProvidedInterface* const interface = component.FindProvided(provided.name);
      if (interface == nullptr) continue;
      auto events = std::make_unique<EventHistory>(name, *interface, memory_, options_.span,
                                                   [this] { Wake(); });
      if (events->has_memory()) {
        events_.push_back(std::move(events));
      } else {
        Log(LogLevel::kWarning, "history",
            "the events of " + process_ + "/" + name + "/" + provided.name +
                " are not kept in the history: too many interfaces have events for a history of " +
                std::to_string(memory_.limit()) + " bytes; give it more (--history-memory)");
      }
    }
  } catch (const std::exception& failure) {  // no memory
    Log(LogLevel::kWarning, "history",
        "the history of component '" + name + "' is not complete: " + failure.what());
  }
}

void ProcessHistory::Remove(const std::string& component) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(tables_, [&](const auto& one) {
    if (one->component() != component) return false;
    missed_rows_ += one->missed();
    return true;
  });
  std::erase_if(events_, [&](const auto& one) {
    if (one->component() != component) return false;
    missed_events_ += one->missed();
    return true;
  });
}

void ProcessHistory::Wake() {
  if (!is_on() || is_urgent_.Get()) return;
  is_urgent_.Set(true);
  wakeup_.Notify();
}

void ProcessHistory::AddLog(LogLevel level, std::string_view source, std::string_view text) {
  if (is_on()) log_queue_.Add(level, source, text);
}

ProcessHistory::LockedTable ProcessHistory::Lock(const StateTable& table) const {
  std::unique_lock lock(mutex_);
  const auto found =
      std::ranges::find_if(tables_, [&](const auto& one) { return &one->table() == &table; });
  return {std::move(lock), found == tables_.end() ? nullptr : found->get()};
}

/// After Wake(), the pauses are short again, because a table may be fast. No pause is shorter
/// than the processor time of the work before it.
void ProcessHistory::Run() {
  os::NameThisThread("history");
  os::LowerPriority();
  const auto is_stopping = [this] { return is_stopping_.Get(); };
  nanoseconds pause = kShortestGap;
  while (!is_stopping()) {
    const bool is_urgent = is_urgent_.Get();
    // Cleared only if it was read, so that a later request is kept.
    if (is_urgent) is_urgent_.Set(false);
    const nanoseconds before = os::ThreadCpuTime();
    nanoseconds until_next = kLongestGap;
    try {
      until_next = Gather();
    } catch (const std::bad_alloc&) {
      // Rows that are not copied now are copied later. If they are overwritten first, they are
      // counted.
    }
    pause = std::clamp(is_urgent ? kShortestGap : 2 * pause, kShortestGap,
                       std::clamp(until_next, kShortestGap, kLongestGap));
    const SteadyTime end = SteadyClock().Now();
    const nanoseconds shortest = std::max(kShortestGap, os::ThreadCpuTime() - before);
    wakeup_.WaitUntil([&] { return is_stopping() || is_urgent_.Get(); },
                      end + std::max(pause, shortest));
    wakeup_.WaitUntil(is_stopping, end + shortest);
  }
}

std::chrono::nanoseconds ProcessHistory::Gather() {
  const SteadyTime now = SteadyClock().Now();
  const bool has_more = GatherTables(now);
  GatherLog(now);
  const std::int64_t oldest = InNanoseconds(now - options_.span);
  const std::scoped_lock lock(mutex_);
  nanoseconds until_next = has_more ? nanoseconds(0) : nanoseconds::max();
  for (const auto& table : tables_) {
    table->ring().DropBefore(oldest);
    until_next = std::min(until_next, table->until_next_read());
  }
  for (const auto& events : events_) {
    events->Gather();
    events->ring().DropBefore(oldest);
  }
  return until_next;
}

/// Releases the lock after each part of a table. Copies at most about 4 MiB of each table, because
/// a table may be written faster than it is copied. If a component is added or removed meanwhile,
/// some tables may be left for the next call.
bool ProcessHistory::GatherTables(SteadyTime now) {
  constexpr int kMaxParts = 64;
  bool has_more = true;
  for (int part = 0; part < kMaxParts && has_more && !is_stopping_.Get(); ++part) {
    has_more = false;
    for (std::size_t i = 0;; ++i) {
      const std::scoped_lock lock(mutex_);
      if (i >= tables_.size()) break;
      has_more = tables_[i]->Gather(now) || has_more;
    }
  }
  return has_more;
}

/// Takes and adds records under one lock, so that the records stay in order. Another thread that
/// finds an empty queue then also finds the records in the history. Takes only a few records at
/// once, because Log() waits in all threads during this time.
void ProcessHistory::GatherLog(SteadyTime now) {
  constexpr std::size_t kAtOnce = 16;
  while (log_queue_.has_news()) {
    const std::scoped_lock lock(mutex_);
    const auto records = log_queue_.Take(kAtOnce, now);
    if (records.empty()) return;  // suppressed records, which are reported later
    for (const message::LogRecord& record : records) AddRecord(record);
    log_.DropBefore(InNanoseconds(now - options_.span));
  }
}

/// The wall clock may have been set since the record was made. Therefore, the steady time is
/// limited to the range from the time of the last record to the present.
void ProcessHistory::AddRecord(const message::LogRecord& record) {
  const std::int64_t now = InNanoseconds(SteadyClock().Now());
  last_record_time_ = std::clamp(record.time - WallMinusSteady(), last_record_time_, now);
  const std::uint64_t number = next_record_++;
  try {
    std::vector<std::byte> body;
    Encode(record, body);
    log_.Append({.number = number, .time = last_record_time_, .tag = 0, .body = body});
  } catch (const std::bad_alloc&) {
    log_.CountDropped(last_record_time_);
  }
}

std::int64_t ProcessHistory::CompleteSince(const HistoryRing& ring, SteadyTime now) const {
  const std::int64_t dropped = ring.last_dropped().value_or(INT64_MIN);
  return std::max({dropped, InNanoseconds(begin_), InNanoseconds(now - options_.span)});
}

Result<message::ReadEventsReply> ProcessHistory::ReadEvents(const message::ReadEvents& wanted) {
  if (!is_on()) return Off();
  if (auto checked = CheckAge(wanted.last); !checked) return checked.error();
  const std::string name = process_ + "/" + wanted.component + "/" + wanted.interface;
  const SteadyTime now = SteadyClock().Now();
  const std::scoped_lock lock(mutex_);
  const auto entry = std::ranges::find_if(events_, [&](const auto& one) {
    return one->component() == wanted.component && one->interface() == wanted.interface;
  });
  if (entry == events_.end()) {
    return Error{ErrorCode::kNotFound, "no events of " + name + " are kept"};
  }
  EventHistory& found = **entry;
  const bool is_first = wanted.epoch == 0;
  if (!is_first && wanted.epoch != found.epoch()) {
    return Error{ErrorCode::kFailed, name + " was replaced meanwhile"};
  }
  found.Gather();
  message::ReadEventsReply reply{
      .epoch = found.epoch(), .end = found.next_number(), .events = found.events()};
  HistoryRing::Cursor cursor = is_first ? found.ring().Since(InNanoseconds(now - wanted.last))
                                        : found.ring().From(wanted.first);
  std::size_t bytes = 0;
  std::optional<HistoryRecord> record = cursor.Next();
  reply.next = is_first ? (record ? record->number : reply.end) : std::min(wanted.first, reply.end);
  for (; record && bytes < kMaxReplyBytes; record = cursor.Next()) {
    reply.lost += record->number - std::exchange(reply.next, record->number + 1);
    reply.past.push_back({.event = record->tag,
                          .time = record->time,
                          .value = {record->body.begin(), record->body.end()}});
    bytes += record->body.size() + sizeof(message::PastEvent);
  }
  if (!record) reply.lost += reply.end - std::exchange(reply.next, reply.end);
  return reply;
}

Result<message::ReadLogReply> ProcessHistory::ReadLog(const message::ReadLog& wanted) {
  if (!is_on()) return Off();
  if (auto checked = CheckAge(wanted.last); !checked) return checked.error();
  const SteadyTime now = SteadyClock().Now();
  if (wanted.first == 0) GatherLog(now);
  const std::scoped_lock lock(mutex_);
  const std::int64_t since = CompleteSince(log_, now);
  message::ReadLogReply reply{.end = next_record_, .since = since + WallMinusSteady()};
  const std::int64_t from = std::max(since, InNanoseconds(now - wanted.last));
  HistoryRing::Cursor cursor = wanted.first == 0 ? log_.Since(from) : log_.From(wanted.first);
  reply.next = reply.end;
  std::size_t bytes = 0;
  while (const auto record = cursor.Next()) {
    if (bytes >= kMaxReplyBytes) {
      reply.next = record->number;
      break;
    }
    message::LogRecord& kept = reply.records.emplace_back();
    (void)Decode(record->body, kept);
    bytes += record->body.size() + sizeof kept;
  }
  return reply;
}

message::ProcessHistoryState ProcessHistory::state() const {
  const SteadyTime now = SteadyClock().Now();
  const std::scoped_lock lock(mutex_);
  message::ProcessHistoryState state{.memory = memory_.used(), .limit = memory_.limit()};
  if (!is_on()) return state;
  state.span = options_.span;
  state.age = now - begin_;
  state.missed_rows = missed_rows_;
  state.missed_events = missed_events_;
  std::int64_t since = CompleteSince(log_, now);
  for (const auto& table : tables_) {
    since = std::max(since, CompleteSince(table->ring(), now));
    state.missed_rows += table->missed();
  }
  for (const auto& events : events_) {
    since = std::max(since, CompleteSince(events->ring(), now));
    state.missed_events += events->missed();
  }
  state.reach = std::max(nanoseconds(0), nanoseconds(InNanoseconds(now) - since));
  return state;
}

Error ProcessHistory::Off() const {
  return {ErrorCode::kFailed,
          "process '" + process_ +
              "' keeps no history: start it with --history-memory and --history-time above 0"};
}

}  // namespace tendon
