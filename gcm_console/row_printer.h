#pragma once

#include <tendon/base/path.h>
#include <tendon/payload/plot_channel.h>
#include <tendon/process/telemetry_client.h>

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace console {

/// One row as it is printed: what was asked for, by path, as JSON text.
struct PrintedRow {
  std::int64_t time_ns = 0;
  std::int64_t clock_offset_ns = 0;  ///< see RowBatch
  std::uint64_t tick = 0;
  std::vector<std::pair<std::string, std::string>> values;
};

/// Turns the rows of one table into values of the paths that were asked for, and keeps them until
/// the printing thread takes them. Rows beyond kMostWaiting are counted as lost here.
class RowPrinter final : public tendon::RowSink {
 public:
  static constexpr std::size_t kMostWaiting = 100000;

  /// `column` of each path says where in the subscription its column is.
  struct Wanted {
    tendon::Path path;
    std::size_t column = 0;
    bool is_found = false;  ///< by a glob: where its part is not there it is left out
  };
  explicit RowPrinter(std::vector<Wanted> wanted) : wanted_(std::move(wanted)) {}

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  std::size_t OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  /// All rows since the last time.
  std::deque<PrintedRow> Take();
  /// That a path names nothing in its column, which no glob has found; no rows come then.
  [[nodiscard]] std::optional<tendon::Error> mistake() const;
  /// Whether all that was wanted is left out; no rows come then.
  [[nodiscard]] bool is_empty() const;
  /// What is left out from now on, and why there are no rows just now: once for each change.
  std::vector<std::string> TakeComplaints();
  /// Why there were no rows the last time that they ceased to come, also if they come again.
  [[nodiscard]] std::optional<tendon::Error> interruption() const;

 private:
  /// False where nothing of the row is to be printed.
  bool Fill(const tendon::RowBatch& batch, std::size_t row, PrintedRow& printed);
  tendon::Result<std::string> Value(std::size_t index, const tendon::RowBatch& batch,
                                    std::size_t row) const;

  const std::vector<Wanted> wanted_;
  mutable std::mutex mutex_;
  std::vector<tendon::Schema> schemas_;
  std::vector<std::optional<tendon::PlotChannel>> numbers_;  // for paths of doubles, which are most
  std::vector<bool> is_left_out_;                            // of those wanted
  std::optional<tendon::Error> mistake_;
  std::deque<PrintedRow> rows_;
  std::vector<std::string> left_out_;  // why, of those since TakeComplaints()
  std::string complaint_;
  std::optional<tendon::Error> interruption_;
};

}  // namespace console
