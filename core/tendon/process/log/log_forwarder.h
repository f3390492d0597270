#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/log/log_queue.h>
#include <tendon/process/log/scoped_log_sink.h>
#include <tendon/proxy/network_thread.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string_view>

namespace tendon {

/// Sends the log records of this process to its GCM. The logging thread puts records into a queue,
/// which the network thread sends every 20 ms. Without a GCM, or while the link is full, the queue
/// keeps the newest records. This class logs nothing itself, because each record would cause
/// another record.
class LogForwarder final : private NetworkJob {
 public:
  static constexpr std::chrono::milliseconds kBetweenBatches{20};
  static constexpr std::size_t kMaxInBatch = 256;  ///< plus one record about lost records

  explicit LogForwarder(std::shared_ptr<NetworkThread> network);
  ~LogForwarder() override;

  /// Sends a record as if this process had logged it.
  void Add(LogLevel level, std::string_view source, std::string_view text);
  /// Sets the channel to the GCM that the process has joined; null while there is no GCM. Any
  /// thread.
  void SetChannel(std::shared_ptr<Channel> channel);
  /// Sends as many of the queued records as the link accepts. Nothing is sent afterwards. Any
  /// thread.
  void Finish();

 private:
  bool Work(SteadyTime now, SteadyTime& next) override;
  void Send(SteadyTime now);

  const std::shared_ptr<NetworkThread> network_;
  LogQueue queue_;

  std::mutex mutex_;
  std::shared_ptr<Channel> channel_;
  Bytes unsent_;            // a batch that the link refused
  std::uint64_t sent_ = 0;  // number of records, including those in `unsent_`
  SteadyTime next_batch_{};

  ScopedLogSink tap_;  // last, because it uses the other members
};

}  // namespace tendon
