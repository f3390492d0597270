#pragma once

#include <tendon/base/error.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/telemetry/receipts/row_receipts.h>
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

/// Certain columns of certain rows of a table, put together once for all viewers who want the same.
/// A viewer that does not keep up loses rows of its own, which it can count, or passes over those
/// that are no longer the newest, as it has chosen; the others lose none for it.
///
/// One thread at a time. The table must live as long.
class RowStream {
 public:
  RowStream(const StateTable& table, std::vector<std::size_t> columns, RowChoice rows);

  [[nodiscard]] bool IsOf(const std::vector<std::size_t>& columns, const RowChoice& rows) const {
    return columns_ == columns && rows_ == rows;
  }

  /// Cells that are read of each row: at least one, for the row itself.
  [[nodiscard]] std::size_t width() const { return std::max<std::size_t>(1, columns_.size()); }
  [[nodiscard]] std::size_t SubscriptionsOf(const Channel& viewer) const;

  /// `lane` is of its rows alone: nothing else waits for them.
  void Add(std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane);
  /// `make` makes the topic where there is none yet. Returns its name.
  const std::string& AddToTopic(const MakeRowTopic& make, std::shared_ptr<Channel> channel,
                                std::uint32_t handle);
  void Remove(const Channel& channel, std::uint32_t handle);
  /// These viewers have taken the newest row, and may have the next.
  void OnRowsTaken(const RowReceipts& receipts);
  void RemoveClosed();
  [[nodiscard]] bool has_viewers() const { return !viewers_.empty() || topic_; }

  /// The next row of the table, whether it is wanted or not; `row` as copied by CopyRow().
  void Take(std::uint64_t tick, std::int64_t time, std::span<const std::uint64_t> row);
  /// As large as a batch should be: send it.
  [[nodiscard]] bool is_full() const;
  /// Sends what was taken since. `lost` rows of the table among them were overwritten, or just
  /// before it; the next row will be that of `next_tick`.
  void Send(std::uint64_t lost, std::uint64_t next_tick);
  /// Tells the viewers that there will be no more; closes the channel of one that cannot be told.
  void End(const Error& reason);

 private:
  struct Viewer {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    Lane lane = kCommonLane;
    std::uint64_t rows_before = 0;
    std::uint64_t lost_table = 0;  // since the last batch that was sent
    bool is_owed = false;          // a batch was refused: it does not know yet what it has lost
    bool is_busy = false;          // with the newest row that it was sent
    std::uint64_t next_tick = 0;   // it has been sent older rows only
  };

  [[nodiscard]] bool Wants(std::int64_t time);
  void SendAll(Viewer& viewer, std::uint64_t lost, std::uint64_t next_tick);
  void SendNewest(Viewer& viewer, std::uint64_t next_tick);

  const StateTable& table_;
  const std::vector<std::size_t> columns_;
  const RowChoice rows_;
  RowBatchWriter batch_;
  std::uint64_t newest_tick_ = 0;        // in the batch
  std::optional<std::int64_t> stretch_;  // of the last row that was wanted, where there is a period
  std::vector<Viewer> viewers_;
  std::unique_ptr<RowTopic> topic_;  // where it has viewers
};

}  // namespace tendon
