#pragma once

#include <tendon/middleware/broadcast.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_viewers.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace tendon {

/// Publishes the rows of one stream once, for all viewers that use a broker. The process does not
/// know which batches arrive. Each viewer computes its losses from the numbers in the batches.
///
/// One thread at a time.
class RowTopic {
 public:
  RowTopic(std::string name, std::unique_ptr<Broadcast::Topic> topic)
      : name_(std::move(name)), topic_(std::move(topic)) {}

  [[nodiscard]] const std::string& name() const { return name_; }

  /// The viewers of this topic. All their messages except rows use their channels.
  [[nodiscard]] ViewerList<RowViewer>& viewers() { return viewers_; }
  [[nodiscard]] const ViewerList<RowViewer>& viewers() const { return viewers_; }

  /// Like RowStream::Send(). Without new rows, it regularly sends an empty batch.
  void Send(RowBatchWriter& batch, std::uint64_t lost, std::uint64_t next_tick);

 private:
  const std::string name_;
  const std::unique_ptr<Broadcast::Topic> topic_;
  ViewerList<RowViewer> viewers_;
  std::uint64_t rows_before_ = 0;
  std::uint64_t lost_table_ = 0;  // rows lost since the last sent batch
  int silence_ = 0;               // calls of Send() since the last sent batch
};

using MakeRowTopic = std::function<std::unique_ptr<RowTopic>()>;

}  // namespace tendon
