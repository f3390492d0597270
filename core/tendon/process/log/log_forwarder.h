#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/log/log_queue.h>
#include <tendon/process/log/log_tap.h>
#include <tendon/proxy/network_thread.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>

namespace tendon {

/// Sends what this process logs to its GCM: the logging thread puts a record into a queue, the
/// network thread sends what is there every 20 ms. While there is no GCM, or its link is full, the
/// queue keeps the newest records. It logs nothing itself, so that it never has itself to send.
class LogForwarder final : private NetworkJob {
 public:
  static constexpr std::chrono::milliseconds kBetweenBatches{20};
  static constexpr std::size_t kMostInBatch = 256;  ///< besides one about those that are lost

  explicit LogForwarder(std::shared_ptr<NetworkThread> network);
  ~LogForwarder() override;

  /// Any thread: the channel that has joined the GCM, or null where it is lost.
  void SetChannel(std::shared_ptr<Channel> channel);
  /// Any thread: sends all that waits, as far as the link takes it, and nothing afterwards.
  void Finish();

 private:
  bool Work(SteadyTime now, SteadyTime& next) override;
  void Send(SteadyTime now);

  const std::shared_ptr<NetworkThread> network_;
  LogQueue queue_;

  std::mutex mutex_;
  std::shared_ptr<Channel> channel_;
  Bytes unsent_;            // a batch for which the link had no room
  std::uint64_t sent_ = 0;  // records, with those in `unsent_`
  SteadyTime next_batch_{};

  LogTap tap_;  // last: it uses the others
};

}  // namespace tendon
