#pragma once

#include <gcm_gui/plot/series/row_losses.h>
#include <gcm_gui/plot/series/sample_ring.h>
#include <gcm_gui/plot/series/value_names.h>
#include <gcm_gui/session/signal_source.h>
#include <tendon/process/telemetry_client.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// Passes the rows of one column from network threads to the GUI thread. For the numbers selected
/// by tap(), it keeps every row; for all other numbers, only the newest row.
///
/// Network threads hold the lock while they read one batch. All other functions are called by the
/// GUI thread and never wait for the lock: if the lock is taken, they postpone their work to the
/// next call.
class ColumnFeed final : public RowSink {
 public:
  /// The default of the maximum number of samples that are stored for each number until they are
  /// taken. Above it, the oldest samples are dropped and count as lost.
  static constexpr std::size_t kMaxWaiting = std::size_t{1} << 18;

  explicit ColumnFeed(std::size_t most_waiting = kMaxWaiting) : most_waiting_(most_waiting) {}

  /// Samples from one run of the source, between two restarts.
  struct Run {
    bool begins_epoch = false;
    std::vector<Sample> samples;
  };
  struct NewSamples {
    std::vector<Run> runs;
    /// The reason why there are no samples; no value if there are samples.
    std::optional<QString> stale;
    /// The names of the number's values, as soon as they are known; null if the values are plain
    /// numbers.
    std::optional<ValueNamesPointer> names;
  };

  void OnSubscribed(const std::vector<Schema>& columns) override;
  void OnRows(const RowBatch& batch) override;
  void OnStale(const Error& reason) override;
  /// Takes the row that was written before the subscription began. A source that writes no further
  /// row has only this one. Ignored if rows have already arrived.
  void takeInitialRow(const RowBatch& batch);
  /// hasRow() and lacksRow() also return false while a network thread is reading a batch.
  [[nodiscard]] bool hasRow();
  [[nodiscard]] bool lacksRow();
  /// Returns true if the subscription was renewed since the last call. The newest row was then
  /// dropped, because it could be very old.
  [[nodiscard]] bool takeRenewed();

  /// Keeps every row of a number from now on. `field_path` is the part of the path after the
  /// column, such as ".position[0]"; it may be empty. While a network thread is reading a batch,
  /// the call takes effect at the next take().
  void tap(const std::string& field_path);
  void untap(const std::string& field_path);
  [[nodiscard]] NewSamples take(const std::string& field_path);
  /// Returns the newest row if a row has arrived or the type of the column has become known since
  /// the last call.
  [[nodiscard]] std::optional<ColumnValues> takeValues();
  /// Returns why there are no rows. Empty if the reason is unknown, or while a network thread is
  /// reading a batch.
  [[nodiscard]] QString refusal();
  /// Returns the losses since the subscription. While a network thread is reading a batch, returns
  /// the previous result.
  [[nodiscard]] RowLosses losses();

 private:
  struct Tap {
    std::optional<NumericField> field;
    std::vector<Run> runs;
    std::size_t waiting = 0;  // number of samples in `runs`
    std::optional<QString> stale;
    std::optional<ValueNamesPointer> names;
  };

  /// A postponed tap() or untap().
  struct Order {
    std::string field_path;
    bool is_wanted = false;
  };

  void order(Order one);
  /// Executes the postponed orders; the caller must hold the lock.
  void executeOrders();
  void resolve(const std::string& field_path, Tap& tap) const;
  void keepNewest(const RowBatch& batch);
  /// Adds the samples of a batch to a tap. Returns the number of dropped samples.
  std::size_t feed(Tap& tap, const RowBatch& batch, bool new_epoch) const;
  [[nodiscard]] NumericFieldList shapeOf(const std::vector<std::byte>& row);

  const std::size_t most_waiting_;
  std::mutex mutex_;
  std::optional<Schema> schema_;
  bool is_picture_ = false;
  bool varies_ = false;  // the schema has sequences, so the fields may differ from row to row
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
