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

/// The rows of one column on their way to the GUI thread: network threads put them in, the GUI
/// thread takes them out. Of tapped numbers every row is kept, of the rest only the newest row.
///
/// Network threads hold the lock for as long as one batch takes to be read. The GUI thread, of
/// which all other functions are, never waits for them: it gets, and taps, the next time.
class ColumnFeed final : public RowSink {
 public:
  /// At most so many samples of a number wait to be taken; newer ones take the place of the oldest,
  /// which are seen as lost.
  static constexpr std::size_t kMostWaiting = std::size_t{1} << 18;

  /// Samples of one start of the source.
  struct Run {
    bool begins_epoch = false;
    std::vector<Sample> samples;
  };
  struct Taken {
    std::vector<Run> runs;
    std::optional<QString> stale;  ///< since then nothing has come, and why
    /// The names of its values, since they have become known; null for numbers.
    std::optional<ValueNamesPointer> names;
  };

  void OnSubscribed(const std::vector<Schema>& columns) override;
  std::size_t OnRows(const RowBatch& batch) override;
  void OnStale(const Error& reason) override;
  /// The row that was there before the subscription, of a source that may write no more of them;
  /// nothing where rows have come already.
  void takeStanding(const RowBatch& batch);
  /// These are also false while a batch is read.
  [[nodiscard]] bool hasRow();
  [[nodiscard]] bool lacksRow();
  /// Whether the subscription has been made anew since the last call, which forgets the newest row:
  /// that may be one of long ago.
  [[nodiscard]] bool takeHealed();

  /// `field` is what follows the column in a path: ".position[0]", or empty. While a batch is read,
  /// it is tapped when something is taken the next time.
  void tap(const std::string& field);
  void untap(const std::string& field);
  [[nodiscard]] Taken take(const std::string& field);
  /// The newest row, when one has come (or the column has become known) since the last call.
  [[nodiscard]] std::optional<ColumnValues> takeValues();
  /// Why no rows come, where that is known, else empty; empty too while a batch is read.
  [[nodiscard]] QString refusal();
  /// Since the beginning; as they were before, while a batch is read.
  [[nodiscard]] RowLosses losses();

 private:
  struct Tap {
    std::optional<PlotChannel> channel;
    std::vector<Run> runs;
    std::size_t waiting = 0;  // samples in the runs
    std::optional<QString> stale;
    std::optional<ValueNamesPointer> names;
  };

  /// Of the GUI thread, for the taps.
  struct Order {
    std::string field;
    bool is_wanted = false;
  };

  void order(Order one);
  /// Under the lock: what was ordered is done.
  void obey();
  void resolve(const std::string& field, Tap& tap) const;
  void keepNewest(const RowBatch& batch);
  /// How many rows had to make room.
  std::size_t feed(Tap& tap, const RowBatch& batch, bool new_epoch) const;
  [[nodiscard]] ChannelList shapeOf(const std::vector<std::byte>& row);

  std::mutex mutex_;
  std::optional<Schema> schema_;
  bool is_picture_ = false;
  bool varies_ = false;  // the schema has sequences, so each row may have other channels
  std::uint64_t epoch_ = 0;
  std::map<std::string, Tap> taps_;
  std::optional<QString> stale_;
  std::vector<std::byte> newest_row_;
  std::int64_t newest_time_ = 0;
  std::uint64_t rows_ = 0;
  RowLosses losses_;
  RowLosses told_losses_;      // of the GUI thread
  std::vector<Order> orders_;  // of the GUI thread
  bool fresh_ = false;
  bool is_healed_ = false;
  ChannelList shape_;
};

}  // namespace tendon::gui
