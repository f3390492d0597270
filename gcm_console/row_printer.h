#pragma once

#include <tendon/base/path.h>
#include <tendon/process/telemetry_client.h>

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace console {

/// One row as it is printed: what was asked for, by path, as JSON text.
struct PrintedRow {
  std::int64_t time_ns = 0;
  std::uint64_t tick = 0;
  std::vector<std::pair<std::string, std::string>> values;
};

/// Turns the rows of one table into values of the paths that were asked for, and keeps them until
/// the printing thread takes them. Rows beyond kMostWaiting are counted as lost here.
class RowPrinter final : public tendon::RowSink {
 public:
  static constexpr std::size_t kMostWaiting = 100000;

  struct Losses {
    std::uint64_t table = 0;
    std::uint64_t network = 0;
    std::uint64_t viewer = 0;
    [[nodiscard]] std::uint64_t all() const { return table + network + viewer; }
  };

  /// `column` of each path says where in the subscription its column is.
  struct Wanted {
    tendon::Path path;
    std::size_t column = 0;
  };
  explicit RowPrinter(std::vector<Wanted> wanted) : wanted_(std::move(wanted)) {}

  void OnSubscribed(const std::vector<tendon::Schema>& columns) override;
  void OnRows(const tendon::RowBatch& batch) override;
  void OnStale(const tendon::Error& reason) override;

  /// All rows since the last time.
  std::deque<PrintedRow> Take();
  [[nodiscard]] Losses losses() const;
  /// Why there are none just now, once for each change; empty otherwise.
  std::string TakeComplaint();

 private:
  std::string Value(const Wanted& wanted, std::span<const std::byte> cell) const;

  const std::vector<Wanted> wanted_;
  mutable std::mutex mutex_;
  std::vector<tendon::Schema> schemas_;
  std::deque<PrintedRow> rows_;
  Losses losses_;
  std::string complaint_;
};

}  // namespace console
