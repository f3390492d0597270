#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/schema.h>
#include <tendon/process/telemetry/row_choice.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// The numbers of lost rows, by the place where they were lost. Each lost row is counted once. The
/// sink counts the rows that it drops in `viewer`. The subscription counts `table` and `network`,
/// from the numbers that the table's process sends with its batches
/// (process/telemetry/row_subscription.h).
///
/// In a subscription to every row, these numbers are complete: the rows that the sink has received,
/// plus `table`, plus `network`, are all rows written since the first announced row. This is also
/// true if the link was broken in between. Only the rows between a restart of the source and the
/// next activation of the subscription are not counted.
///
/// In a subscription with a period, `table` counts all rows, even rows that the period skips.
/// `network` does not count rows that the period skips, or that were written while the link was
/// down. In a subscription to only the newest row, `table` stays 0.
struct LostRows {
  std::uint64_t table = 0;    ///< overwritten before the table's process could read them
  std::uint64_t network = 0;  ///< refused by the link, or written while there was no link
  std::uint64_t viewer = 0;   ///< received, but dropped by the sink

  [[nodiscard]] std::uint64_t all() const { return table + network + viewer; }
  LostRows& operator+=(const LostRows& other) {
    table += other.table;
    network += other.network;
    viewer += other.viewer;
    return *this;
  }
  bool operator==(const LostRows&) const = default;
};

/// Rows of one state table, in order, that arrived in one batch. Valid only during the call.
struct RowBatch {
  std::uint64_t epoch = 0;  ///< changes when the source restarts; ticks then start at 0
  LostRows lost;          ///< lost since the last batch; `viewer` is 0, because the sink counts it
  std::size_t count = 0;  ///< 0 if there is only a loss to report
  std::span<const std::uint64_t> ticks;  ///< one per row; consecutive without a period
  /// The time of each row, ns on the source's steady clock, limited to 0 to 50 years.
  std::span<const std::int64_t> times;
  /// Subtract this offset from a row's time to get the time on this process's steady clock. Then
  /// rows of several hosts can share one time axis. The offset is constant within a batch. Between
  /// batches it follows the estimate by at most 500 ppm, and rows never go back in time. 0 on one
  /// host.
  std::chrono::nanoseconds clock_offset{0};
  /// The largest possible error of clock_offset. Before the first estimate, it is the largest value
  /// of the type.
  std::chrono::nanoseconds clock_uncertainty = std::chrono::nanoseconds::max();
  /// Returns the CDR body of a column in a row, in the format of the column's schema.
  std::function<std::span<const std::byte>(std::size_t row, std::size_t column)> cell;
};

/// Receives a subscription's rows, in a thread of the middleware. Must not block.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// Called when the subscription has become active, and after each recovery. `columns` are in the
  /// order of the request.
  virtual void OnSubscribed(const std::vector<Schema>& columns) = 0;
  virtual void OnRows(const RowBatch& batch) = 0;
  /// Called when no rows arrive for now, because the process is absent or has refused the
  /// subscription. The client keeps trying.
  virtual void OnStale(const Error& reason) = 0;
};

/// The columns and rows of one table: "robot", "arm", "state", {"Joints"}.
struct TableSubscription {
  std::string process{};
  std::string component{};
  std::string table{};  ///< the name of the table's interface: "state" or "state-NAME"
  std::vector<std::string> columns{};
  RowChoice rows = {};  ///< every row by default
};

/// The result of ReadPast().
struct PastRows {
  std::uint64_t rows = 0;  ///< rows that were read
  /// Missing rows: they were written between the rows that were read, but were not kept.
  std::uint64_t lost = 0;
  std::chrono::nanoseconds reach{0};  ///< the age of the oldest row that was read; 0 without rows
  std::optional<Error> failure;       ///< the reason why not all rows could be read
};

/// Subscribes to state tables of any process. Rows arrive in batches of 20 to 50 ms. A subscription
/// recovers by itself when its process comes back. Thread-safe.
class TelemetryClient {
 public:
  virtual ~TelemetryClient() = default;
  using Id = std::uint64_t;
  /// A process allows each client at most 2048 subscriptions. If a row of a table has N values, the
  /// process reads at most 32 N values of the row for one client. Values for several subscriptions
  /// to the same columns and rows are read once. A subscription beyond these limits, or with a
  /// column named twice, is refused, and the sink gets OnStale().
  virtual Id Subscribe(const TableSubscription& subscription, std::shared_ptr<RowSink> sink) = 0;
  /// Ends a subscription. After this function has returned, the sink is not called any more. Must
  /// not be called from a sink.
  virtual void Unsubscribe(Id id) = 0;
  /// Reads the rows of `table` that its process still has, in its history and in the table, and
  /// that are not older than `last`, oldest first. The sink gets OnSubscribed(), then OnRows().
  /// Then `done` is called once, in a thread of the middleware or of the client. After the end of
  /// the client, neither the sink nor `done` is called. Neither of them may destroy the client. If
  /// the reading fails, the sink has received the rows before the failure. Fails like Subscribe().
  virtual void ReadPast(const TableSubscription& table, std::chrono::nanoseconds last,
                        std::shared_ptr<RowSink> sink, std::function<void(const PastRows&)> done) {
    static_cast<void>(table);
    static_cast<void>(last);
    static_cast<void>(sink);
    done({.failure = Error{ErrorCode::kFailed, "this client cannot read kept rows"}});
  }
  /// Tries the subscriptions of a process again at once. Call it when the process has returned or
  /// has another address.
  virtual void Retry(const std::string& process) { static_cast<void>(process); }
};

}  // namespace tendon
