#pragma once

#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/log/log_messages.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon::server {

/// The newest records of all processes, and their watchers. A watcher is a position in the buffer:
/// a slow one delays nobody and costs nothing. If records are dropped before a watcher has read
/// them, the watcher sees a gap. Not thread-safe; never blocks.
class LogBuffer {
 public:
  static constexpr std::size_t kKept = 4096;

  /// Adds records from a process; the GCM knows its name and instance. If earlier records were lost
  /// with a broken link, adds a record that says so.
  void Add(const std::string& process, std::uint64_t instance, message::LogRecords batch);
  /// Adds a record of the GCM's own program, under the process name kGcmName.
  void AddOwn(message::LogRecord record);
  /// Called when a process is removed from the catalogue.
  void Forget(const std::string& process) { senders_.erase(process); }

  /// Adds a watcher that starts at record number `after`: its last position in the log of this GCM,
  /// or 0 for all kept records. Pump() sends the records.
  message::WatchLogReply Watch(const std::shared_ptr<Channel>& channel, std::uint64_t after);
  void Remove(const Channel* channel) { watchers_.erase(channel); }

  /// Sends records to the watchers whose links had room at the last attempt.
  void Pump();
  /// The same, but also tries the other watchers.
  void PumpAll();

 private:
  struct Sender {
    std::uint64_t instance = 0;
    std::uint64_t next = 0;  ///< number of the next record
  };
  struct Watcher {
    std::shared_ptr<Channel> channel;
    std::uint64_t next = 0;  ///< number of the next record to send
    bool is_full = false;    ///< its link had no room
  };
  /// A frame for several watchers.
  struct Batch {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    Bytes body;
  };

  void Write(message::LogRecord record);
  void Send(Watcher& watcher, Batch& batch) const;
  [[nodiscard]] Batch BatchFrom(std::uint64_t number) const;

  std::deque<message::LogRecord> records_;
  std::uint64_t first_ = 0;  // number of the oldest record
  std::uint64_t end_ = 0;    // number of the next record to be added
  std::map<std::string, Sender> senders_;
  std::map<const Channel*, Watcher> watchers_;
};

}  // namespace tendon::server
