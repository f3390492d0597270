#pragma once

#include <tendon/base/error.h>
#include <tendon/process/telemetry/row_stream.h>
#include <tendon/state/row_cursor.h>
#include <tendon/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// Reads the rows of one state table once for all viewers of its columns. When the batch of one
/// stream is full, the batches of all streams are sent.
///
/// One thread at a time. The table must outlive the feed.
class TableFeed {
 public:
  TableFeed(std::string component, const StateTable& table);

  [[nodiscard]] const std::string& component() const { return component_; }
  [[nodiscard]] bool IsOf(const StateTable& table) const { return &table_ == &table; }
  /// The tick of the first row that a viewer gets if it is added now.
  [[nodiscard]] std::uint64_t next_tick() const { return rows_.next_tick(); }

  /// Adds a viewer. `handle` is the number that this process has issued for the subscription.
  /// `lane` is used only for its rows. A viewer that wants only the newest row gets the present row
  /// at once, even if no more rows are written.
  void Add(const std::vector<std::size_t>& columns, const RowChoice& rows,
           std::shared_ptr<Channel> channel, std::uint32_t handle, Lane lane);
  /// Adds a viewer that gets every row through a topic; returns the name of the topic.
  const std::string& AddToTopic(const std::vector<std::size_t>& columns, const MakeRowTopic& make,
                                std::shared_ptr<Channel> channel, std::uint32_t handle);
  void Remove(const Channel& channel, std::uint32_t handle);
  void OnRowsTaken(const RowAcknowledgements& acknowledgements);
  [[nodiscard]] bool has_viewers() const { return !streams_.empty(); }
  [[nodiscard]] std::size_t SubscriptionsOf(const Channel& viewer) const;
  /// Returns the number of cells that are read per row for a viewer, including the given
  /// subscription. Cells for several subscriptions to the same columns and rows are read once.
  [[nodiscard]] std::size_t CellsFor(const Channel& viewer, const std::vector<std::size_t>& columns,
                                     const RowChoice& rows) const;

  /// Sends the rows written since the last call, or one full batch. Returns true if more rows wait.
  bool Gather();
  [[nodiscard]] bool has_more() const { return has_more_; }
  /// True if all rows that were written so far have been sent to the viewers.
  [[nodiscard]] bool HasSentAll() const;
  void End(const Error& reason);

 private:
  /// Adds the present row to the stream, unless Gather() will read this row.
  void TakeNewest(RowStream& stream);
  RowStream& StreamOf(const std::vector<std::size_t>& columns, const RowChoice& rows);
  [[nodiscard]] bool IsBatchFull() const;
  void RemoveUnwatched();

  const std::string component_;
  const StateTable& table_;
  RowCursor rows_;
  bool has_more_ = false;
  std::list<RowStream> streams_;
};

}  // namespace tendon
