#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/event_sink.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/supervisor/children_messages.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/telemetry_client.h>
#include <tendon/process/version_messages.h>
#include <tendon/security/role.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// The next records of the log of all processes, oldest first.
struct LogBatch {
  std::vector<message::LogRecord> records;
  std::uint64_t lost = 0;   ///< records before these that the GCM did not keep long enough
  bool is_current = false;  ///< includes all records that the GCM had when it was asked
};

/// Receives the events of a GCM, in a thread of the middleware or of the client; must not block.
/// The window turns each into a queued signal.
class GcmListener {
 public:
  virtual ~GcmListener() = default;
  /// The whole catalogue: after the first connect, after a gap, and when the GCM came back.
  virtual void OnSnapshot(const Catalogue& catalogue) = 0;
  /// The next changes, which follow the last ones without a gap.
  virtual void OnChanges(const std::vector<CatalogueChange>& changes) = 0;
  /// The GCM cannot be reached; the client tries again every second.
  virtual void OnGcmLost(const Error& reason) = 0;
  /// Called after GcmClient::WatchLog(). Texts and sources are printable.
  virtual void OnLog(const LogBatch& /*batch*/) {}
};

/// A viewer's connection to a system: watches a GCM's catalogue, asks the GCM for changes, and
/// talks to the processes directly for data. Recovers by itself. Functions with a handler return at
/// once and call it exactly once, in a thread of the middleware. The others wait for at most
/// `timeout` and must not be called from a handler.
class GcmClient {
 public:
  /// Replace() and Undo() may take this many times `timeout`: the GCM breaks the old connection,
  /// makes the new one, and if that fails restores the old one.
  static constexpr int kOrdersOfAReplacement = 3;

  /// Undo() may take this many times `timeout`. The GCM gives all orders within five times, however
  /// many components must run again; the last time is for stopping them if one does not.
  static constexpr int kOrdersOfAnUndo = 6;

  /// Steer() may take this many times `timeout`: once to execute, once to report.
  static constexpr int kOrdersOfALife = 2;

  /// SteerProcess() may take this many times `timeout`: to start or end the process, to wait until
  /// it joins or to kill it, and to report.
  static constexpr int kOrdersOfAProcess = 5;

  /// The client and its GCM.
  struct Options {
    std::string name = "viewer";  ///< in the GCM's history and log: "gcm connect", "gcm-gui"
    std::string address;          ///< of the GCM
    /// Longer than the GCM waits for a process, so that the GCM can report its answer.
    std::chrono::milliseconds timeout{2000};
    /// Gives up all other rights: the GCM and each process then refuse a viewer's changes.
    Role role = Role::kOperator;
  };

  /// Does not wait for the GCM: see WaitUntilWatching().
  GcmClient(std::shared_ptr<Middleware> middleware, Options options,
            std::shared_ptr<GcmListener> listener = nullptr);
  GcmClient(const GcmClient&) = delete;
  GcmClient& operator=(const GcmClient&) = delete;
  ~GcmClient();

  /// Waits for the first snapshot. kUnreachable: "no GCM at X (refused); start one with: gcm
  /// serve".
  Result<void> WaitUntilWatching();

  /// A copy of the current catalogue.
  [[nodiscard]] Catalogue catalogue() const;
  /// Calls `look` with the current catalogue, without a copy. The client is locked meanwhile, so
  /// `look` must be short and must not use the client.
  void Look(const std::function<void(const Catalogue&)>& look) const;

  /// Asks the GCM for the whole catalogue again, for the listener. Does nothing if that is under
  /// way or there is no GCM.
  void Resync();

  using ConnectHandler = std::function<void(Result<ConnectionDescription>)>;
  using DoneHandler = std::function<void(Result<void>)>;
  using TextHandler = std::function<void(Result<std::string>)>;

  void Connect(const InterfaceName& required, const InterfaceName& provided,
               ConnectHandler handler);
  /// First disconnects the required interface. Connects it to its old peer again if the new
  /// connection is refused, or works less than the old one. One step of the history.
  void Replace(const InterfaceName& required, const InterfaceName& provided,
               ConnectHandler handler);
  void Disconnect(const InterfaceName& required, DoneHandler handler);
  /// An order for the life cycle of a component, or to load a plug-in. May take twice
  /// `order.patience`, which is `timeout` by default. Valid only for the process instance in the
  /// catalogue now.
  void Steer(const message::LifeOrder& order, DoneHandler handler);
  /// Starts an `lcm` on the GCM's host, or ends one that the GCM started. May take
  /// kOrdersOfAProcess times as long as other requests.
  void SteerProcess(message::ProcessOrder order, DoneHandler handler);
  /// The processes that the GCM has started. kDenied by a GCM older than this request.
  void GetChildren(std::function<void(Result<message::Children>)> handler);
  /// The classes of which a process can create components, and the plug-ins that it could load.
  void GetClasses(const std::string& process,
                  std::function<void(Result<message::Classes>)> handler);
  using StepHandler = std::function<void(Result<message::HistoryEntry>)>;
  /// Undoes the newest step; if `step` is not 0, only if it is that one.
  void Undo(StepHandler handler, std::uint64_t step = 0);
  /// Marks the newest step as not to be undone, so that earlier ones can be. kFailed if the step
  /// can be undone and is not named by `step`, or if its process may come back.
  void PassOver(StepHandler handler, std::uint64_t step = 0);
  /// Reserves the execution of plans for this client, until GivePlanTurnBack() or the end of the
  /// link. kFailed names the current holder.
  void TakePlanTurn(DoneHandler handler);
  void GivePlanTurnBack();
  void GetHistory(std::function<void(Result<message::History>)> handler);
  /// The resources that processes use, as last reported to the GCM.
  void GetHealth(std::function<void(Result<message::SystemHealth>)> handler);
  /// The version of a process, or of the GCM if it is empty. kDenied by a program older than this
  /// request; kFailed if it is not reached or refuses us.
  void GetVersion(const std::string& process,
                  std::function<void(Result<message::ProgramVersion>)> handler);
  /// The counts of the connection of a required interface, from its process. kNotFound; kFailed if
  /// it is not active.
  void GetCounts(const InterfaceName& required,
                 std::function<void(Result<ConnectionCounts>)> handler);
  /// The provided side's counts of a connection to another process: its capacity and lost events.
  /// kNotFound if it has none.
  void GetServed(const message::Wire& wire, std::function<void(Result<ConnectionCounts>)> handler);
  /// The fill of the mailboxes of a component.
  void GetFill(const std::string& process, const std::string& component,
               std::function<void(Result<MailboxFill>)> handler);
  /// Removes a tombstone.
  void Forget(const std::string& process, DoneHandler handler);

  /// From now on the listener gets the log of all processes: first the newest records that the GCM
  /// has kept, then each within some 100 ms. Continues after a broken link; a restarted GCM has the
  /// records logged meanwhile.
  void WatchLog();
  /// The process drops records below `level` from now on. kNotFound; kFailed if it is gone.
  void SetLogLevel(const std::string& process, LogLevel level, DoneHandler handler);

  /// Calls any command of a process by its path: reads, qualified reads, void and write commands
  /// alike. `argument` is JSON (empty for none), and so is the answer ("" for none).
  void Call(const std::string& path, const std::string& argument, TextHandler handler);

  using ListenerId = std::uint64_t;
  /// The sink gets the events of any process as they are raised, until StopListening(). Recovers by
  /// itself. A component never waits for its listeners; events without room are lost and counted.
  ListenerId Listen(const EventSubscription& events, std::shared_ptr<EventSink> sink);
  /// After it returns the sink is not called any more. Must not be called from a sink.
  void StopListening(ListenerId id);

  /// The schema of a payload type as a process knows it, by fingerprint; cached.
  void GetSchema(const std::string& process, Fingerprint fingerprint,
                 std::function<void(Result<Schema>)> handler);

  /// Fetches the schemas of types that share a name with another type of the catalogue, so that
  /// FindSchema() knows them and Compare() can name the difference. Call it at every change: it
  /// looks at the catalogue at most twice a second.
  void LearnDisputedTypes(DoneHandler handler);

  /// State-table rows of any process: see TelemetryClient.
  [[nodiscard]] TelemetryClient& telemetry();

 private:
  class Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

/// Waits for the answer of one of the functions above: `Wait<ConnectionDescription>(timeout,
/// [&](auto handler) { client.Connect(a, b, handler); })`. kTimeout if it does not come in time;
/// the request may still be executed. Must not be called from a handler.
template <typename T, typename Start>
Result<T> Wait(std::chrono::milliseconds timeout, Start&& start) {
  const auto answer = std::make_shared<std::promise<Result<T>>>();
  auto arrival = answer->get_future();
  std::forward<Start>(start)(std::function<void(Result<T>)>(
      [answer](Result<T> result) { answer->set_value(std::move(result)); }));
  if (arrival.wait_for(timeout) == std::future_status::ready) return arrival.get();
  return Error{ErrorCode::kTimeout, "no answer within " + std::to_string(timeout.count()) +
                                        " ms; whether it was done is unknown"};
}

}  // namespace tendon
