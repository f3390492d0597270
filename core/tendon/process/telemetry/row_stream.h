#pragma once

#include <tendon/base/error.h>
#include <tendon/middleware/broadcast.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/process/telemetry/row_choice.h>
#include <tendon/state/state_table.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
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

/// A viewer's subscription to a stream.
struct RowViewer {
  std::shared_ptr<Channel> channel;
  std::uint32_t handle = 0;
  Lane lane = kCommonLane;  ///< lane for the viewer's rows
};

/// Notifies the viewer that its rows have ended. Closes the viewer's channel if the notice cannot
/// be sent.
void ReportEnd(const RowViewer& viewer, const Error& reason);

/// Returns the number of bytes of a cell for each of these columns; 0 if this number differs from
/// row to row.
[[nodiscard]] std::vector<std::uint32_t> CellSizes(const StateTable& table,
                                                   const std::vector<std::size_t>& columns);

/// The viewers of one stream or topic. The state of one viewer has the type `Viewer`, which is
/// RowViewer or derived from RowViewer.
///
/// One thread at a time.
template <std::derived_from<RowViewer> Viewer>
class ViewerList {
 public:
  void Add(Viewer viewer) { viewers_.push_back(std::move(viewer)); }
  void Remove(const Channel& channel, std::uint32_t handle) {
    std::erase_if(viewers_, [&](const Viewer& viewer) {
      return viewer.channel.get() == &channel && viewer.handle == handle;
    });
  }
  void RemoveClosed() {
    std::erase_if(viewers_, [](const Viewer& viewer) { return !viewer.channel->is_open(); });
  }
  /// Reports the end to all viewers and removes them. If a report cannot be sent, closes the
  /// channel of the viewer.
  void EndAll(const Error& reason) {
    for (const Viewer& viewer : viewers_) ReportEnd(viewer, reason);
    viewers_.clear();
  }

  [[nodiscard]] bool empty() const { return viewers_.empty(); }
  [[nodiscard]] std::size_t CountOf(const Channel& channel) const {
    return static_cast<std::size_t>(std::ranges::count_if(
        viewers_, [&](const Viewer& viewer) { return viewer.channel.get() == &channel; }));
  }
  [[nodiscard]] auto begin() { return viewers_.begin(); }
  [[nodiscard]] auto end() { return viewers_.end(); }
  [[nodiscard]] auto begin() const { return viewers_.begin(); }
  [[nodiscard]] auto end() const { return viewers_.end(); }

 private:
  std::vector<Viewer> viewers_;
};

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

}  // namespace tendon
