#pragma once

#include <tendon/base/error.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_choice.h>
#include <tendon/process/telemetry/row_topic.h>
#include <tendon/process/telemetry/row_viewers.h>
#include <tendon/state/state_table.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// The acknowledged subscriptions of each channel.
using RowAcknowledgements = std::map<std::shared_ptr<Channel>, std::set<std::uint32_t>>;

[[nodiscard]] bool Includes(const RowAcknowledgements& acknowledgements,
                            const std::shared_ptr<Channel>& channel, std::uint32_t handle);

/// Sends rows with chosen columns of a table. The rows are built once for all viewers with the same
/// choice. A slow viewer loses rows, which it can count, or skips outdated rows, depending on its
/// choice. Other viewers are not affected.
///
/// One thread at a time. The table must outlive the stream.
class RowStream {
 public:
  RowStream(const StateTable& table, std::vector<std::size_t> columns, RowChoice rows);

  [[nodiscard]] bool IsOf(const std::vector<std::size_t>& columns, const RowChoice& rows) const {
    return columns_ == columns && rows_ == rows;
  }

  /// The number of cells that are read for each row, but at least 1.
  [[nodiscard]] std::size_t width() const { return std::max<std::size_t>(1, columns_.size()); }
  [[nodiscard]] std::size_t SubscriptionsOf(const Channel& viewer) const;

  /// Adds a viewer. `lane` is used only for its rows, so that no other message waits for them.
  void Add(std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane);
  /// Adds a viewer that gets its rows through the topic. Calls `make` if there is no topic yet.
  /// Returns the topic's name.
  const std::string& AddToTopic(const MakeRowTopic& make, std::shared_ptr<Channel> channel,
                                std::uint32_t handle);
  void Remove(const Channel& channel, std::uint32_t handle);
  /// Records that these viewers have received the newest row and may get the next row.
  void OnRowsTaken(const RowAcknowledgements& acknowledgements);
  void RemoveClosed();
  [[nodiscard]] bool has_viewers() const { return !viewers_.empty() || topic_; }
  /// True if no viewer waits for rows that were taken.
  [[nodiscard]] bool has_sent_all() const;

  /// Adds the next row of the table if the viewers want it. `row` is a copy made by CopyRow().
  void Take(std::uint64_t tick, std::int64_t time, std::span<const std::uint64_t> row);
  /// True if the batch is full, so that Send() must be called.
  [[nodiscard]] bool is_full() const;
  /// Sends the rows taken since the last call. `lost` is the number of rows that were overwritten
  /// in or just before this batch; `next_tick` is the tick of the next row.
  void Send(std::uint64_t lost, std::uint64_t next_tick);
  /// Reports the end to all viewers. If a report cannot be sent, closes the channel of the viewer.
  void End(const Error& reason);

 private:
  struct DirectViewer : RowViewer {
    std::uint64_t rows_before = 0;
    std::uint64_t lost_table = 0;  // rows lost since the last sent batch
    bool is_owed = false;  // a batch was refused, and the viewer does not know of the loss yet
    bool is_busy = false;  // the viewer has not acknowledged the newest row
    std::uint64_t next_tick = 0;  // rows with smaller ticks were sent to the viewer
  };

  [[nodiscard]] bool Wants(std::int64_t time);
  void SendAll(DirectViewer& viewer, std::uint64_t lost, std::uint64_t next_tick);
  void SendNewest(DirectViewer& viewer, std::uint64_t next_tick);

  const StateTable& table_;
  const std::vector<std::size_t> columns_;
  const RowChoice rows_;
  RowBatchWriter batch_;
  std::uint64_t newest_tick_ = 0;        // newest tick in the batch
  std::optional<std::int64_t> stretch_;  // period number of the last chosen row
  ViewerList<DirectViewer> viewers_;
  std::unique_ptr<RowTopic> topic_;  // set if the topic has viewers
};

/// Returns the number of bytes of a cell for each of these columns; 0 if this number differs from
/// row to row.
[[nodiscard]] std::vector<std::uint32_t> CellSizes(const StateTable& table,
                                                   const std::vector<std::size_t>& columns);

}  // namespace tendon
