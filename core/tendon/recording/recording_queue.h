#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/error.h>
#include <tendon/gcm/client.h>
#include <tendon/payload/fingerprint.h>
#include <tendon/payload/schema.h>
#include <tendon/recording/recording_entry.h>

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon::recording {

/// The queue between the threads of the middleware, which receive rows and events, and the thread
/// that writes the file. Its size in bytes is limited. If an entry does not fit, it is counted as
/// lost. No thread waits for the writer, so a slow disk never slows down a component.
///
/// If it is the listener of a GcmClient, the log and the catalogue are recorded, too.
///
/// Thread safety: any thread may call all functions. Cost: a batch of rows is copied once, outside
/// of the lock.
class RecordingQueue final : public GcmListener,
                             public std::enable_shared_from_this<RecordingQueue> {
 public:
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;

  explicit RecordingQueue(std::size_t most_bytes = kMaxBytes) : most_bytes_(most_bytes) {}

  /// Returns the sink for the rows of this table.
  std::shared_ptr<RowSink> SinkOf(const TableSubscription& table);
  /// Returns the sink for these events or these commands; a subscription has only one of the two.
  /// Events and calls whose types are not among `types` are counted as lost.
  std::shared_ptr<EventSink> SinkOf(const EventSubscription& events,
                                    std::map<Fingerprint, Schema> types);

  /// Waits until an entry has arrived or Wake() is called, at most `timeout`. Removes and returns
  /// the oldest entries, about 1 MiB. Called by the writing thread.
  std::deque<RecordingEntry> Take(std::chrono::nanoseconds timeout);
  /// Lets Take() return.
  void Wake();
  /// Drops all entries, and all later entries, without counting them as lost.
  void Close();

  [[nodiscard]] Losses losses() const;
  /// Returns and resets, for each table, the losses of rows after the last accepted row.
  [[nodiscard]] std::map<std::string, LostRows> TakeTrailingLosses();
  [[nodiscard]] std::size_t waiting_bytes() const;
  /// Returns sentences about interruptions since the last call: at most 100, each once.
  std::vector<std::string> TakeNotices();
  [[nodiscard]] bool is_gcm_lost() const;
  /// True if all log records that the GCM had at the time of the request have arrived.
  [[nodiscard]] bool has_past_log() const;
  /// The number of times that the whole catalogue has arrived. If the number changes, the catalogue
  /// may come from another GCM, with other revisions.
  [[nodiscard]] std::uint64_t snapshots() const;
  /// True if changes of the catalogue did not fit. Then call GcmClient::Resync().
  [[nodiscard]] bool needs_snapshot() const;

  void OnSnapshot(const Catalogue& catalogue) override;
  void OnChanges(const std::vector<CatalogueChange>& changes) override;
  void OnGcmLost(const Error& reason) override;
  void OnLog(const LogBatch& batch) override;

 private:
  class TableSink;
  class InterfaceSink;

  /// Returns false if there is no room. Called with the lock held.
  bool Push(RecordingEntry entry, std::size_t size);
  void Notice(std::string sentence);

  const std::size_t most_bytes_;
  mutable std::mutex mutex_;
  std::condition_variable arrival_;
  std::deque<RecordingEntry> entries_;
  std::size_t bytes_ = 0;  // of the entries
  bool is_woken_ = false;
  bool is_closed_ = false;
  Losses losses_;
  std::map<std::string, LostRows> trailing_losses_;  // not in the `lost_before` of any entry yet
  std::vector<std::string> notices_;
  bool is_gcm_lost_ = false;
  bool needs_snapshot_ = false;
  std::uint64_t snapshots_ = 0;
  bool is_log_current_ = false;  // while false, lost log records do not count
};

}  // namespace tendon::recording
