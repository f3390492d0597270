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

/// The newest log records of all processes, and the watchers that receive them. A watcher is only a
/// position in the buffer, so a slow watcher does not delay others and needs no additional memory.
/// If records are dropped before they are sent to a watcher, the watcher detects a gap. Not
/// thread-safe; never blocks.
class LogBuffer {
 public:
  static constexpr std::size_t kKept = 4096;

  /// Adds records from a process. Uses the name and the instance that the GCM knows, and ignores
  /// those in the records. If earlier records were lost with a broken link, also adds a record that
  /// reports the loss.
  void Add(const std::string& process, std::uint64_t instance, message::LogRecords batch);
  /// Adds a record of the GCM's own program, with the process name kGcmName.
  void AddOwn(message::LogRecord record);
  /// Called when a process is removed from the catalogue.
  void Forget(const std::string& process) { senders_.erase(process); }

  /// Adds a watcher. `after` is the number of the first record that the watcher gets; 0 means all
  /// kept records. Pump() sends the records.
  message::WatchLogReply Watch(const std::shared_ptr<Channel>& channel, std::uint64_t after);
  void Remove(const Channel* channel) { watchers_.erase(channel); }

  /// Sends each watcher the records that it does not have yet. Skips watchers whose links were full
  /// at the last attempt.
  void Pump();
  /// Like Pump(), but does not skip watchers.
  void PumpAll();

 private:
  struct Sender {
    std::uint64_t instance = 0;
    std::uint64_t next = 0;  ///< number of the next record
  };
  struct Watcher {
    std::shared_ptr<Channel> channel;
    std::uint64_t next = 0;  ///< number of the next record to send
    bool is_full = false;    ///< true if its link was full at the last attempt
  };
  /// An encoded frame, which can be sent to several watchers.
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
