#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/middleware.h>
#include <tendon/payload/schema.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Rows of one state table, in order, as they arrived in one batch. Valid during the call.
struct RowBatch {
  std::uint64_t epoch = 0;  ///< new when the source was restarted or re-subscribed
  std::uint64_t lost_table =
      0;  ///< rows overwritten before they could be gathered, since the last batch
  std::uint64_t lost_network = 0;  ///< rows sent that did not arrive, since the last batch
  std::size_t count = 0;
  std::span<const std::uint64_t> ticks;  ///< of each row: grows by one without loss
  std::span<const std::int64_t> times;   ///< of each row, ns on the source's steady clock
  /// Column c of row r: its CDR body, as the column's schema says.
  std::function<std::span<const std::byte>(std::size_t row, std::size_t column)> cell;
};

/// What a subscriber hears, in a thread of the middleware; must not block.
class RowSink {
 public:
  virtual ~RowSink() = default;
  /// The subscription stands; the columns' schemas in the order asked for. Again after healing.
  virtual void OnSubscribed(const std::vector<Schema>& columns) = 0;
  virtual void OnRows(const RowBatch& batch) = 0;
  /// No rows for now: the process is gone or refused; the client keeps trying.
  virtual void OnStale(const Error& reason) = 0;
};

/// Which columns of which table: "robot", "arm", "state", {"Joints"}.
struct TableSubscription {
  std::string process;
  std::string component;
  std::string table;  ///< its interface's name: "state" or "state-NAME"
  std::vector<std::string> columns;
};

/// Subscribes to state tables of any process; every row arrives, in batches of 20 to 50 ms. Heals
/// by itself when a process comes back. Thread-safe.
class TelemetryClient {
 public:
  virtual ~TelemetryClient() = default;
  using Id = std::uint64_t;
  virtual Id Subscribe(const TableSubscription& subscription, std::shared_ptr<RowSink> sink) = 0;
  /// After it returns the sink hears nothing more. Not from a sink's function.
  virtual void Unsubscribe(Id id) = 0;
  /// The process has come back or moved: its subscriptions are tried again at once.
  virtual void Retry(const std::string& process) { static_cast<void>(process); }
};

/// Where a process is reached now; the error says why it is not. Called off the middleware's
/// threads.
using ResolveAddress = std::function<Result<std::string>(const std::string& process)>;

/// Opens channels to processes on demand and says `mine` there.
std::unique_ptr<TelemetryClient> MakeTelemetryClient(std::shared_ptr<Middleware> middleware,
                                                     ResolveAddress resolve, Hello mine);

}  // namespace tendon
