#pragma once

#include <tendon/base/dropping_queue.h>
#include <tendon/base/path.h>
#include <tendon/payload/plot_channel.h>
#include <tendon/process/telemetry_client.h>

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace console {

/// Rows of a table that are lost, apart as in RowCounts.
struct LostRows {
  std::uint64_t table = 0;
  std::uint64_t network = 0;
  std::uint64_t viewer = 0;

  [[nodiscard]] std::uint64_t all() const { return table + network + viewer; }
  LostRows& operator+=(const LostRows& other);
};

/// One row as it is printed: what was asked for, by path, as JSON text.
struct PrintedRow {
  std::int64_t time_ns = 0;
  std::int64_t clock_offset_ns = 0;  ///< see RowBatch
  std::uint64_t tick = 0;
  LostRows lost_before;  ///< between the last one and this
  std::vector<std::pair<std::string, std::string>> values;
};

/// Keeps the rows of one table as they come, until the printing thread takes them as values of the
/// paths that were asked for. What waits is bounded in rows and bytes; newer rows take the place of
/// the oldest, which are counted as lost here.
class RowPrinter final : public tendon::RowSink {
 public:
  /// At one go, or a single row.
  static constexpr std::size_t kMostTaken = std::size_t{1} << 20U;  // bytes
  static constexpr tendon::QueueBound kMostWaiting = {.elements = 100000,
                                                      .bytes = std::size_t{32} << 20U};

  /// `column` of each path says where in the subscription its column is.
  struct Wanted {
    tendon::Path path;
    std::size_t column = 0;
    bool is_found = false;  ///< by a glob: where its part is not there it is left out
  };
  /// With RowDelivery::kNewest, no row waits but the newest, and those before it are not lost.
  explicit RowPrinter(std::vector<Wanted> wanted,
                      tendon::RowDelivery delivery = tendon::RowDelivery::kAll);

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  std::size_t OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  /// The oldest rows that wait, at most kMostTaken of them. Of the printing thread.
  std::deque<PrintedRow> Take();
  /// Whether more can be taken.
  [[nodiscard]] bool has_more() const;
  /// Of the rows that can be taken.
  [[nodiscard]] std::size_t waiting_bytes() const;
  /// What is lost behind the last row that was taken, with those that could be taken, which are
  /// dropped. Of the printing thread.
  LostRows Rest();
  /// That a path names nothing in its column, which no glob has found; no rows come then.
  [[nodiscard]] std::optional<tendon::Error> mistake() const;
  /// Whether all that was wanted is left out; no rows come then.
  [[nodiscard]] bool is_empty() const;
  /// What is left out from now on, and why there are no rows just now: once for each change.
  std::vector<std::string> TakeComplaints();
  /// Why there were no rows the last time that they ceased to come, also if they come again.
  [[nodiscard]] std::optional<tendon::Error> interruption() const;

 private:
  /// How the columns are read since they were subscribed to.
  struct Columns {
    std::vector<tendon::Schema> schemas;
    std::vector<std::optional<tendon::PlotChannel>> numbers;  // for paths of numbers, as most are
    std::vector<bool> is_left_out;                            // of those wanted; of the mutex
  };
  /// A row as it came.
  struct KeptRow {
    std::int64_t time_ns = 0;
    std::int64_t clock_offset_ns = 0;
    std::uint64_t tick = 0;
    LostRows lost_before;
    std::shared_ptr<Columns> columns;
    std::vector<std::vector<std::byte>> cells;

    [[nodiscard]] std::size_t size() const;
  };
  using Rows = tendon::DroppingQueue<KeptRow>;

  /// False where nothing of the row is to be printed.
  bool Fill(const KeptRow& row, PrintedRow& printed);
  [[nodiscard]] tendon::Result<std::string> Value(std::size_t index, const KeptRow& row) const;

  const std::vector<Wanted> wanted_;
  const tendon::RowDelivery delivery_;
  mutable std::mutex mutex_;
  std::shared_ptr<Columns> columns_;
  std::optional<tendon::Error> mistake_;
  Rows rows_;
  LostRows lost_;                      // since the newest row that waits
  LostRows gap_;                       // since the last row that was taken; of the printing thread
  std::vector<std::string> left_out_;  // why, of those since TakeComplaints()
  std::string complaint_;
  std::optional<tendon::Error> interruption_;
};

}  // namespace console
