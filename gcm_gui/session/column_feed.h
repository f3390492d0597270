#pragma once

#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/value_names.h>
#include <gcm_gui/session/signal_source.h>
#include <tendon/process/telemetry_client.h>

#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// Passes the rows of one column from network threads to the GUI thread. Keeps every row of tapped
/// numbers, and only the newest row of the others.
///
/// Network threads hold the lock while they read one batch. The GUI thread calls all other
/// functions; they never wait for the lock. If it is taken, they do their work in the next call.
class ColumnFeed final : public RowSink {
 public:
  /// The maximum number of waiting samples per number; when it is reached, the oldest are dropped
  /// and count as lost.
  static constexpr std::size_t kMostWaiting = std::size_t{1} << 18;

  /// Samples from one run of the source.
  struct Run {
    bool begins_epoch = false;
    std::vector<Sample> samples;
  };
  struct NewSamples {
    std::vector<Run> runs;
    std::optional<QString> stale;  ///< set while there are no samples: the reason
    /// The names of the number's values, once known; null for plain numbers.
    std::optional<ValueNamesPointer> names;
  };

  void OnSubscribed(const std::vector<Schema>& columns) override;
  void OnRows(const RowBatch& batch) override;
  void OnStale(const Error& reason) override;
  /// Takes the row that existed before the subscription, because the source may write no further
  /// row. Ignored if rows have already arrived.
  void takeInitialRow(const RowBatch& batch);
  /// These also return false while a batch is being read.
  [[nodiscard]] bool hasRow();
  [[nodiscard]] bool lacksRow();
  /// Returns true if the subscription was renewed since the last call. Then also drops the newest
  /// row, which may be very old.
  [[nodiscard]] bool takeRenewed();

  /// `field_path` is the part of a path after the column: ".position[0]", or empty. If a batch is
  /// being read, the tap starts at the next take.
  void tap(const std::string& field_path);
  void untap(const std::string& field_path);
  [[nodiscard]] NewSamples take(const std::string& field_path);
  /// The newest row, if one has arrived or the column has become known since the last call.
  [[nodiscard]] std::optional<ColumnValues> takeValues();
  /// The reason why there are no rows, if known; also empty while a batch is being read.
  [[nodiscard]] QString refusal();
  /// The losses since the beginning; the previous result while a batch is being read.
  [[nodiscard]] RowLosses losses();

 private:
  struct Tap {
    std::optional<NumericField> field;
    std::vector<Run> runs;
    std::size_t waiting = 0;  // samples in `runs`
    std::optional<QString> stale;
    std::optional<ValueNamesPointer> names;
  };

  /// An order of the GUI thread for the taps.
  struct Order {
    std::string field_path;
    bool is_wanted = false;
  };

  void order(Order one);
  /// Executes the orders; call it with the lock held.
  void executeOrders();
  void resolve(const std::string& field_path, Tap& tap) const;
  void keepNewest(const RowBatch& batch);
  /// Returns the number of dropped samples.
  std::size_t feed(Tap& tap, const RowBatch& batch, bool new_epoch) const;
  [[nodiscard]] NumericFieldList shapeOf(const std::vector<std::byte>& row);

  std::mutex mutex_;
  std::optional<Schema> schema_;
  bool is_picture_ = false;
  bool varies_ = false;  // the schema has sequences: fields may differ from row to row
  std::uint64_t epoch_ = 0;
  std::map<std::string, Tap> taps_;
  std::optional<QString> stale_;
  std::vector<std::byte> newest_row_;
  std::int64_t newest_time_ = 0;
  std::uint64_t rows_ = 0;
  LostRows losses_;
  RowLosses known_losses_;     // GUI thread only
  std::vector<Order> orders_;  // GUI thread only
  bool fresh_ = false;
  bool is_renewed_ = false;
  NumericFieldList shape_;
};

}  // namespace tendon::gui
