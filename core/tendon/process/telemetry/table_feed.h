#pragma once

#include <tendon/base/clock.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/state/state_table.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Gathers certain columns of one state table, once for all who watch them, and sends every row to
/// each. A viewer that does not keep up loses rows, which it can count; the others do not notice.
///
/// One thread at a time. The table must live as long.
class TableFeed {
 public:
  TableFeed(std::string component, const StateTable& table, std::vector<std::size_t> columns);

  [[nodiscard]] const std::string& component() const { return component_; }
  [[nodiscard]] bool IsOf(const StateTable& table, const std::vector<std::size_t>& columns) const {
    return &table_ == &table && columns_ == columns;
  }

  /// From the next row on. `handle` is our number of the subscription.
  void Add(std::shared_ptr<Channel> channel, std::uint32_t handle);
  void Remove(const Channel& channel, std::uint32_t handle);
  [[nodiscard]] bool has_viewers() const { return !viewers_.empty(); }

  /// Sends what has been written since; true when it stopped half-way.
  bool Gather();
  /// Tells the viewers that there will be no more; closes the channel of one that cannot be told.
  void End(const Error& reason);

 private:
  struct Viewer {
    std::shared_ptr<Channel> channel;
    std::uint32_t handle = 0;
    std::uint64_t rows_before = 0;
    std::uint64_t lost_table = 0;  // since the last batch that was sent
  };

  /// Some rows; false when there are none.
  bool GatherBatch();
  void SendBatch(std::uint64_t lost);

  const std::string component_;
  const StateTable& table_;
  const std::vector<std::size_t> columns_;
  RowBatchWriter batch_;
  std::uint64_t next_tick_ = 0;
  std::vector<std::uint64_t> row_;
  std::vector<Viewer> viewers_;
};

}  // namespace tendon
