#pragma once

#include <tendon/middleware/broadcast.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/telemetry/row_batch.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// Publishes the rows of one stream once, for all viewers that use a broker. The process does not
/// know which batches arrive; from the numbers in the batches, each viewer sees its losses.
///
/// One thread at a time.
class RowTopic {
 public:
  RowTopic(std::string name, std::unique_ptr<Broadcast::Topic> topic)
      : name_(std::move(name)), topic_(std::move(topic)) {}

  [[nodiscard]] const std::string& name() const { return name_; }

  /// Adds a viewer. Its channel carries all messages except rows.
  void Add(std::shared_ptr<Channel> channel, std::uint32_t handle);
  void Remove(const Channel& channel, std::uint32_t handle);
  void RemoveClosed();
  [[nodiscard]] bool has_viewers() const { return !viewers_.empty(); }
  [[nodiscard]] std::size_t SubscriptionsOf(const Channel& viewer) const;

  /// Like RowStream::Send(). Without new rows, it regularly sends an empty batch.
  void Send(RowBatchWriter& batch, std::uint64_t lost, std::uint64_t next_tick);
  /// Like RowStream::End().
  void End(const Error& reason);

 private:
  struct Viewer {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
  };

  const std::string name_;
  const std::unique_ptr<Broadcast::Topic> topic_;
  std::vector<Viewer> viewers_;
  std::uint64_t rows_before_ = 0;
  std::uint64_t lost_table_ = 0;  // since the last sent batch
  int silence_ = 0;               // calls of Send() since the last sent batch
};

using MakeRowTopic = std::function<std::unique_ptr<RowTopic>()>;

}  // namespace tendon
