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

/// One row for printing: the wanted values by path, as JSON text.
struct PrintedRow {
  std::int64_t time_ns = 0;
  std::int64_t clock_offset_ns = 0;  ///< see RowBatch
  std::uint64_t tick = 0;
  tendon::LostRows lost_before;  ///< between the previous row and this one
  std::vector<std::pair<std::string, std::string>> values;
};

/// Keeps the incoming rows of one table until the printing thread takes them as values of the
/// wanted paths. The queue is bounded in rows and bytes; when it is full, the oldest rows are
/// dropped and counted as lost here.
class RowInbox final : public tendon::RowSink {
 public:
  /// `column` is the index of the path's column in the subscription.
  struct Wanted {
    tendon::Path path;
    std::size_t column = 0;
    bool is_found = false;  ///< found by a glob; left out if the part does not exist
  };
  /// RowDelivery::kNewest keeps only the newest row; replaced rows do not count as lost.
  explicit RowInbox(std::vector<Wanted> wanted,
                    tendon::RowDelivery delivery = tendon::RowDelivery::kAll);

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  void OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  /// Takes the oldest waiting rows, at most kMostTaken. Call it in the printing thread only.
  std::deque<PrintedRow> Take();
  /// True if more rows can be taken.
  [[nodiscard]] bool has_more() const;
  /// The size of the waiting rows.
  [[nodiscard]] std::size_t waiting_bytes() const;
  /// Drops the waiting rows. Returns the number of rows lost after the last taken row, including
  /// those dropped. Call it in the printing thread only.
  tendon::LostRows Rest();
  /// Set if a path that was not found by a glob does not exist in its column; then there are no
  /// rows.
  [[nodiscard]] std::optional<tendon::Error> mistake() const;
  /// True if every path is left out; then there are no rows.
  [[nodiscard]] bool is_empty() const;
  /// New messages about omitted paths and interrupted rows; each change is reported once.
  std::vector<std::string> TakeNotices();
  /// The reason of the last interruption, even if rows arrive again.
  [[nodiscard]] std::optional<tendon::Error> interruption() const;

 private:
  /// How to read the columns of one subscription.
  struct Columns {
    std::vector<tendon::Schema> schemas;
    std::vector<std::optional<tendon::NumericField>> numbers;  // set for numbers, the usual case
    std::vector<bool> is_left_out;                             // by path; guarded by mutex_
  };
  /// A received row.
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

  /// Returns false if the row has nothing to print.
  bool Fill(const KeptRow& row, PrintedRow& printed);
  [[nodiscard]] tendon::Result<std::string> Value(std::size_t index, const KeptRow& row) const;

  const std::vector<Wanted> wanted_;
  const tendon::RowDelivery delivery_;
  mutable std::mutex mutex_;
  std::shared_ptr<Columns> columns_;
  std::optional<tendon::Error> mistake_;
  Rows rows_;
  tendon::LostRows lost_;              // since the newest waiting row
  tendon::LostRows gap_;               // since the last taken row; printing thread only
  std::vector<std::string> left_out_;  // reasons since TakeNotices()
  std::string complaint_;
  std::optional<tendon::Error> interruption_;
};

}  // namespace console
