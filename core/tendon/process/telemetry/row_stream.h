#pragma once

#include <tendon/base/error.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/telemetry/row_acknowledgements.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_choice.h>
#include <tendon/process/telemetry/row_topic.h>
#include <tendon/state/state_table.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Rows with chosen columns of a table, built once for all viewers with the same choice. A slow
/// viewer loses rows, which it can count, or skips outdated rows, as it has chosen; other viewers
/// are not affected.
///
/// One thread at a time. The table must outlive the stream.
class RowStream {
 public:
  RowStream(const StateTable& table, std::vector<std::size_t> columns, RowChoice rows);

  [[nodiscard]] bool IsOf(const std::vector<std::size_t>& columns, const RowChoice& rows) const {
    return columns_ == columns && rows_ == rows;
  }

  /// Number of cells read for each row; counts as at least one.
  [[nodiscard]] std::size_t width() const { return std::max<std::size_t>(1, columns_.size()); }
  [[nodiscard]] std::size_t SubscriptionsOf(const Channel& viewer) const;

  /// `lane` is used for these rows only, so that no other message waits for them.
  void Add(std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane);
  /// Calls `make` if there is no topic yet. Returns the topic's name.
  const std::string& AddToTopic(const MakeRowTopic& make, std::shared_ptr<Channel> channel,
                                std::uint32_t handle);
  void Remove(const Channel& channel, std::uint32_t handle);
  /// These viewers have received the newest row and may get the next.
  void OnRowsTaken(const RowAcknowledgements& receipts);
  void RemoveClosed();
  [[nodiscard]] bool has_viewers() const { return !viewers_.empty() || topic_; }

  /// Adds the next row of the table if the viewers chose it; `row` is a copy made by CopyRow().
  void Take(std::uint64_t tick, std::int64_t time, std::span<const std::uint64_t> row);
  /// True if the batch is full, so that Send() must be called.
  [[nodiscard]] bool is_full() const;
  /// Sends the rows taken since the last call. `lost` is the number of rows that were overwritten
  /// in or just before this batch; `next_tick` is the tick of the next row.
  void Send(std::uint64_t lost, std::uint64_t next_tick);
  /// Reports the end to all viewers; closes the channel of a viewer to which the report cannot be
  /// sent.
  void End(const Error& reason);

 private:
  struct Viewer {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    Lane lane = kCommonLane;
    std::uint64_t rows_before = 0;
    std::uint64_t lost_table = 0;  // since the last sent batch
    bool is_owed = false;          // a batch was refused: the viewer does not know of the loss yet
    bool is_busy = false;          // has not acknowledged the newest row
    std::uint64_t next_tick = 0;   // ticks below this were sent to the viewer
  };

  [[nodiscard]] bool Wants(std::int64_t time);
  void SendAll(Viewer& viewer, std::uint64_t lost, std::uint64_t next_tick);
  void SendNewest(Viewer& viewer, std::uint64_t next_tick);

  const StateTable& table_;
  const std::vector<std::size_t> columns_;
  const RowChoice rows_;
  RowBatchWriter batch_;
  std::uint64_t newest_tick_ = 0;        // newest tick in the batch
  std::optional<std::int64_t> stretch_;  // period number of the last chosen row
  std::vector<Viewer> viewers_;
  std::unique_ptr<RowTopic> topic_;  // set if the topic has viewers
};

}  // namespace tendon
