#pragma once

#include <tendon/base/log.h>
#include <tendon/base/result.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/process/history/event_history.h>
#include <tendon/process/history/history_messages.h>
#include <tendon/process/history/history_ring.h>
#include <tendon/process/history/table_history.h>
#include <tendon/process/log/log_queue.h>
#include <tendon/process/log/scoped_log_sink.h>
#include <tendon/process/process.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace tendon {

/// Keeps the last seconds of all state tables, events and log records of a process, so that they
/// can be saved after something unexpected has happened. The time span and the memory are limited.
///
/// A thread of low priority copies new rows before their tables overwrite them. It looks at the
/// tables as often as their rates require, at most every 2 ms and at least four times a second. It
/// uses at most half a core. If it misses rows or events because of this limit, they are counted.
/// The only cost for a component is the copy of the value of each event that it raises.
///
/// Thread safety: all functions, from any thread. Wake() never waits, and AddLog() waits at most
/// while another thread takes a few records. The other functions wait while another thread adds or
/// removes a component, uses a LockedTable, empties the queues of the events, or copies about
/// 128 KiB.
class ProcessHistory {
 public:
  ProcessHistory(std::string process, HistoryOptions options);
  ProcessHistory(const ProcessHistory&) = delete;
  ProcessHistory& operator=(const ProcessHistory&) = delete;
  ~ProcessHistory();

  /// Begins to keep the tables and events of the component, which must not run yet. Does not throw.
  /// Logs a warning if there is no memory for some of them.
  void Add(Component& component);
  /// Must be called before the component is removed.
  void Remove(const std::string& component);
  /// Must be called when a component may have been started, so that its first rows are not missed.
  void Wake();
  /// Adds a record to the log of the process that does not come from Log().
  void AddLog(LogLevel level, std::string_view source, std::string_view text);

  /// Access to the kept rows of one table. The history does not change while this object exists.
  class LockedTable {
   public:
    /// Returns null if the history keeps no rows of this table.
    [[nodiscard]] const TableHistory* get() const { return table_; }

   private:
    friend class ProcessHistory;
    LockedTable(std::unique_lock<std::mutex> lock, const TableHistory* table)
        : lock_(std::move(lock)), table_(table) {}

    std::unique_lock<std::mutex> lock_;
    const TableHistory* table_;
  };
  [[nodiscard]] LockedTable Lock(const StateTable& table) const;

  /// Returns the next page of events. Errors: kNotFound if no events of the interface are kept;
  /// kFailed if the interface was replaced after the first reply, or if the process keeps no
  /// history; kInvalid for a time below zero.
  Result<message::ReadEventsReply> ReadEvents(const message::ReadEvents& wanted);
  /// Returns the next page of log records. Errors: kFailed if the process keeps no history;
  /// kInvalid for a time below zero.
  Result<message::ReadLogReply> ReadLog(const message::ReadLog& wanted);
  [[nodiscard]] message::ProcessHistoryState state() const;

 private:
  void Run();
  /// Copies new rows, events and log records. Returns the time after which the next call is due.
  std::chrono::nanoseconds Gather();
  /// Returns true if rows are left.
  bool GatherTables(SteadyTime now);
  void GatherLog(SteadyTime now);
  void AddRecord(const message::LogRecord& record);
  /// Returns the steady time, in ns, from which on all records of the ring's series are kept.
  [[nodiscard]] std::int64_t CompleteSince(const HistoryRing& ring, SteadyTime now) const;
  [[nodiscard]] bool is_on() const { return options_.memory > 0 && options_.span.count() > 0; }
  [[nodiscard]] Error Off() const;

  const std::string process_;
  const HistoryOptions options_;
  const SteadyTime begin_;

  mutable std::mutex mutex_;  // guards the members below; locked after the manager's lock
  HistoryMemory memory_;
  std::vector<std::unique_ptr<TableHistory>> tables_;
  std::vector<std::unique_ptr<EventHistory>> events_;
  HistoryRing log_;
  std::uint64_t next_record_ = 0;
  std::int64_t last_record_time_ = 0;
  std::uint64_t missed_rows_ = 0;    // of removed components
  std::uint64_t missed_events_ = 0;  // of removed components

  LogQueue log_queue_;
  Wakeup<> wakeup_;
  Flag is_stopping_;
  Flag is_urgent_;
  std::optional<ScopedLogSink> log_sink_;  // empty if the process keeps no history
  std::thread thread_;                     // does not run if the process keeps no history
};

}  // namespace tendon
