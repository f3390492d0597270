#pragma once

#include <tendon/base/error.h>
#include <tendon/process/telemetry/row_stream.h>
#include <tendon/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// Gathers the rows of one state table, each once, for all who watch any of its columns. A batch
/// ends for all of them where one of its streams is full.
///
/// One thread at a time. The table must live as long.
class TableFeed {
 public:
  TableFeed(std::string component, const StateTable& table);

  [[nodiscard]] const std::string& component() const { return component_; }
  [[nodiscard]] bool IsOf(const StateTable& table) const { return &table_ == &table; }
  /// The first row that a viewer will hear of who is added now.
  [[nodiscard]] std::uint64_t next_tick() const { return next_tick_; }

  /// `handle` is our number of the subscription, `lane` that of its rows alone. Who wants the
  /// newest row alone is sent the one that is there, also where no more are written.
  void Add(const std::vector<std::size_t>& columns, const RowChoice& rows,
           std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane);
  /// Every row, by a topic; returns its name.
  const std::string& AddToTopic(const std::vector<std::size_t>& columns, const MakeRowTopic& make,
                                std::shared_ptr<Channel> channel, std::uint32_t handle);
  void Remove(const Channel& channel, std::uint32_t handle);
  void OnRowsTaken(const RowReceipts& receipts);
  [[nodiscard]] bool has_viewers() const { return !streams_.empty(); }
  [[nodiscard]] std::size_t SubscriptionsOf(const Channel& viewer) const;
  /// Cells that are read of each row for a viewer, once it has this subscription besides. What its
  /// subscriptions have in common is read once where they are of the same columns and rows.
  [[nodiscard]] std::size_t CellsFor(const Channel& viewer, const std::vector<std::size_t>& columns,
                                     const RowChoice& rows) const;

  /// Sends what has been written since, or until a batch is full; true when there is more.
  bool Gather();
  [[nodiscard]] bool has_more() const { return has_more_; }
  void End(const Error& reason);

 private:
  /// The row that is there, unless Gather() comes to it.
  void TakeNewest(RowStream& stream);
  RowStream& StreamOf(const std::vector<std::size_t>& columns, const RowChoice& rows);
  /// The next row was overwritten while it was read: goes on with one that will be there for
  /// longer, the longer the more often that happens in a row. Returns how many are lost by it.
  std::uint64_t FallBehind();
  [[nodiscard]] bool IsBatchFull() const;
  void RemoveUnwatched();

  const std::string component_;
  const StateTable& table_;
  std::uint64_t next_tick_ = 0;
  bool has_more_ = false;
  std::uint64_t head_start_ = 0;  // before the writer, in rows, of where it went on last
  std::vector<std::uint64_t> row_;
  std::list<RowStream> streams_;
};

}  // namespace tendon
