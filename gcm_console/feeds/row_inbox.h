#pragma once

#include <gcm_console/feeds/inbox_queue.h>
#include <tendon/base/dropping_queue.h>
#include <tendon/base/path.h>
#include <tendon/payload/numeric_field.h>
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

/// One row to be printed, with the requested values by path as JSON text.
struct PrintedRow {
  std::int64_t time_ns = 0;
  std::int64_t clock_offset_ns = 0;  ///< see RowBatch
  std::uint64_t tick = 0;
  tendon::LostRows lost_before;  ///< rows lost between the previous row and this one
  std::vector<std::pair<std::string, std::string>> values;
};

/// Stores the rows of one table until the printing thread takes them as values of the requested
/// paths. The queue is limited in rows and bytes. When it is full, the oldest rows are dropped and
/// counted as lost.
class RowInbox final : public tendon::RowSink {
 public:
  /// `column` is the index of the path's column in the subscription.
  struct WantedPath {
    tendon::Path path;
    std::size_t column = 0;
    bool is_found = false;  ///< found by a glob; left out if the column does not have this part
  };
  /// With RowDelivery::kNewest, stores only the newest row. A row that is replaced by a newer row
  /// does not count as lost.
  explicit RowInbox(std::vector<WantedPath> wanted,
                    tendon::RowDelivery delivery = tendon::RowDelivery::kAll);

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  void OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  /// Removes and returns the oldest rows, at most kMaxTaken bytes. Call it only in the printing
  /// thread.
  std::deque<PrintedRow> Take();
  /// True if more rows can be taken.
  [[nodiscard]] bool has_more() const;
  /// Returns the size of the rows that were not taken yet.
  [[nodiscard]] std::size_t waiting_bytes() const;
  /// Drops the rows that were not taken. Returns the number of rows lost after the last row that
  /// was taken, including the dropped ones. Call it only in the printing thread.
  tendon::LostRows Rest();
  /// Returns an error if a path that the user has typed without a glob does not exist in its
  /// column. In this case, the inbox stores no rows.
  [[nodiscard]] std::optional<tendon::Error> mistake() const;
  /// Returns true if all paths are left out. In this case, the inbox stores no rows.
  [[nodiscard]] bool is_empty() const;
  /// Returns the new messages about paths that are left out and about interruptions. Each message
  /// is returned once.
  std::vector<std::string> TakeNotices();
  /// Returns the reason of the last interruption, even if rows arrive again.
  [[nodiscard]] std::optional<tendon::Error> interruption() const;

 private:
  /// Describes how to read the columns of one subscription.
  struct Columns {
    std::vector<tendon::Schema> schemas;
    std::vector<std::optional<tendon::NumericField>> numbers;  // set if the value is a number
    std::vector<bool> is_left_out;  // one for each path; guarded by mutex_
  };
  /// A row as received.
  struct KeptRow {
    std::int64_t time_ns = 0;
    std::int64_t clock_offset_ns = 0;
    std::uint64_t tick = 0;
    tendon::LostRows lost_before;
    std::shared_ptr<Columns> columns;
    std::vector<std::vector<std::byte>> cells;

    [[nodiscard]] std::size_t size() const;
  };
  using Rows = tendon::DroppingQueue<KeptRow>;

  /// Fills `printed` with the requested values. Returns false if the row has nothing to print.
  bool Fill(const KeptRow& row, PrintedRow& printed);
  [[nodiscard]] tendon::Result<std::string> Value(std::size_t index, const KeptRow& row) const;

  const std::vector<WantedPath> wanted_;
  const tendon::RowDelivery delivery_;
  mutable std::mutex mutex_;
  std::shared_ptr<Columns> columns_;
  std::optional<tendon::Error> mistake_;
  Rows rows_;
  tendon::LostRows lost_;              // rows lost since the newest stored row
  tendon::LostRows gap_;               // rows lost since the last taken row; printing thread only
  std::vector<std::string> left_out_;  // paths left out since the last TakeNotices(), with reasons
  std::string complaint_;
  std::optional<tendon::Error> interruption_;
};

}  // namespace console
