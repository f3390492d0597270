#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>
#include <tendon/payload/schema.h>
#include <tendon/process/telemetry/row_choice.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Rows of one state table, in order, as they arrived in one batch. Valid during the call.
struct RowBatch {
  std::uint64_t epoch = 0;  ///< new when the source was restarted; its ticks count from 0 again
  /// Rows overwritten before they could be gathered, since the last batch.
  std::uint64_t lost_table = 0;
  /// Rows of ours that were refused a place on the link, or written while there was none, since the
  /// last batch.
  std::uint64_t lost_network = 0;
  std::size_t count = 0;                 ///< may be 0, where there is only a loss to be told
  std::span<const std::uint64_t> ticks;  ///< of each row: of every row, grows by one without loss
  std::span<const std::int64_t> times;   ///< of each row, ns on the source's steady clock
  /// Taken off a row's time, it gives the time on this process' steady clock: so the rows of
  /// several hosts fit on one axis. The same for all rows of a batch; from batch to batch it
  /// follows the estimate by at most 500 ppm, and no row comes to lie before the last. 0 on one
  /// host.
  std::chrono::nanoseconds clock_offset{0};
  /// How far the estimate may be off; the largest value before there is one.
  std::chrono::nanoseconds clock_uncertainty = std::chrono::nanoseconds::max();
  /// Column c of row r: its CDR body, as the column's schema says.
  std::function<std::span<const std::byte>(std::size_t row, std::size_t column)> cell;
};

/// What a subscriber hears, in a thread of the middleware; must not block.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// The subscription stands; the columns' schemas in the order asked for. Again after healing.
  virtual void OnSubscribed(const std::vector<Schema>& columns) = 0;
  /// Returns how many rows, of these or of earlier ones, had to be dropped: lost in the viewer.
  virtual std::size_t OnRows(const RowBatch& batch) = 0;
  /// No rows for now: the process is gone or refused; the client keeps trying.
  virtual void OnStale(const Error& reason) = 0;
};

/// Which rows of which columns of which table: "robot", "arm", "state", {"Joints"}.
struct TableSubscription {
  std::string process;
  std::string component;
  std::string table;  ///< its interface's name: "state" or "state-NAME"
  std::vector<std::string> columns;
  RowChoice rows = {};  ///< every row unless said otherwise
};

/// What has become of the rows of a subscription since it was made. Of every row, received +
/// lost_table + lost_network grows by the number that was written from the first on that was
/// announced, also while the link was down, once the next batch has come. Where the source was
/// restarted it goes on from there, without what was written before the subscription stood again.
/// With a period, rows that were not chosen are not counted, but for those in lost_table, of which
/// nobody knows, nor what was written while the link was down. With the newest row only, nothing is
/// counted as lost_table.
struct RowCounts {
  std::uint64_t received = 0;  ///< handed to the sink, among them lost_viewer
  std::uint64_t lost_table = 0;
  std::uint64_t lost_network = 0;
  std::uint64_t lost_viewer = 0;

  bool operator==(const RowCounts&) const = default;
};

/// Subscribes to state tables of any process; rows arrive in batches of 20 to 50 ms. Heals by
/// itself when a process comes back. Thread-safe.
class TelemetryClient {
 public:
  virtual ~TelemetryClient() = default;
  using Id = std::uint64_t;
  /// A process gives each client at most 2048 subscriptions, and reads for it of one table at most
  /// 32 times as many values as a row has; what is of the same columns and rows is read once. It
  /// refuses what is more, and a column named twice, which the sink hears as OnStale().
  virtual Id Subscribe(const TableSubscription& subscription, std::shared_ptr<RowSink> sink) = 0;
  /// After it returns the sink hears nothing more. Not from a sink's function.
  virtual void Unsubscribe(Id id) = 0;
  /// The process has come back or moved: its subscriptions are tried again at once.
  virtual void Retry(const std::string& process) { static_cast<void>(process); }
  /// Zeroes where there is no such subscription. Not from a sink's function.
  [[nodiscard]] virtual RowCounts CountsOf(Id id) const = 0;
};

/// Where a process is reached now; the error says why it is not. Called off the middleware's
/// threads.
using ResolveAddress = std::function<Result<std::string>(const std::string& process)>;

/// Where the broker is by which processes reach many viewers at once, or why there is none. Called
/// off the middleware's threads; may be null.
using FindFanOut = std::function<Result<std::string>()>;

/// Opens channels to processes on demand and says `mine` there. Every row of a table comes by the
/// broker, where there is one and the process and the middleware know the way; else, and where that
/// brings nothing for some seconds, it comes directly, which the log says.
std::unique_ptr<TelemetryClient> MakeTelemetryClient(std::shared_ptr<Middleware> middleware,
                                                     ResolveAddress resolve, Hello mine,
                                                     FindFanOut find_fan_out = nullptr);

}  // namespace tendon
