#pragma once

#include <tendon/gcm/messages.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/log/messages.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon::server {

/// The newest records of all processes, and who watches them. A watcher is a place in the book: who
/// does not read stays behind, holds nobody up and costs nothing; what has left the book before it
/// was read is a hole that the watcher sees. Not thread-safe; never blocks.
class LogBook {
 public:
  static constexpr std::size_t kKept = 4096;

  /// What the process has sent, its name and instance as the GCM knows them. What is missing before
  /// it, for a link broke on which it had been sent, is told as a record.
  void Add(const std::string& process, std::uint64_t instance, message::LogRecords batch);
  /// A record of the GCM's own program, as of a process kGcmName.
  void AddOwn(message::LogRecord record);
  /// The process is gone for good.
  void Forget(const std::string& process) { senders_.erase(process); }

  /// The channel's place, from record number `after` on: where a watcher of this GCM was before, or
  /// 0 for all that is kept. The records come with Pump().
  message::LogWatched Watch(const std::shared_ptr<Channel>& channel, std::uint64_t after);
  void Remove(const Channel* channel) { watchers_.erase(channel); }

  /// Sends what the links of watchers take now that have had room so far.
  void Pump();
  /// Tries the others again, too.
  void PumpAll();

 private:
  struct Sender {
    std::uint64_t instance = 0;
    std::uint64_t next = 0;  ///< the number of the record that comes next
  };
  struct Watcher {
    std::shared_ptr<Channel> channel;
    std::uint64_t next = 0;  ///< the number of the record that it is sent next
    bool is_full = false;    ///< its link had no room
  };
  /// A frame that several watchers need.
  struct Batch {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
    Bytes body;
  };

  void Write(message::LogRecord record);
  void Send(Watcher& watcher, Batch& batch) const;
  [[nodiscard]] Batch BatchFrom(std::uint64_t number) const;

  std::deque<message::LogRecord> records_;
  std::uint64_t first_ = 0;  // the number of the oldest
  std::uint64_t end_ = 0;    // that of the next to be written
  std::map<std::string, Sender> senders_;
  std::map<const Channel*, Watcher> watchers_;
};

}  // namespace tendon::server
