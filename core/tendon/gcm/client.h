#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/event_sink.h>
#include <tendon/gcm/gcm_messages.h>
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
  std::uint64_t lost = 0;   ///< earlier records that the GCM no longer had
  bool is_current = false;  ///< includes all records that the GCM had at the time of the request
};

/// Receives the events of a GCM, in a thread of the middleware or of the client; must not block.
/// The window converts each call to a queued signal.
class GcmListener {
 public:
  virtual ~GcmListener() = default;
  /// Called with the whole catalogue after the first connect, after a gap, and when the GCM is
  /// back.
  virtual void OnSnapshot(const Catalogue& catalogue) = 0;
  /// The next changes, which follow the last ones without a gap.
  virtual void OnChanges(const std::vector<CatalogueChange>& changes) = 0;
  /// The GCM cannot be reached; the client tries again every second.
  virtual void OnGcmLost(const Error& reason) = 0;
  /// Called after GcmClient::WatchLog(). Texts and sources are printable.
  virtual void OnLog(const LogBatch& /*batch*/) {}
};

/// A viewer's connection to a system: watches a GCM's catalogue, asks the GCM for changes, and
/// exchanges data with the processes directly. Reconnects by itself. Functions with a handler
/// return at once and call it exactly once, in a thread of the middleware. The others wait for at
/// most `timeout` and must not be called from a handler.
class GcmClient {
 public:
  /// A Connect() that replaces may take this many times `timeout`: the GCM ends the old connection,
  /// makes the new one, and restores the old one if that fails.
  static constexpr int kReplaceTimeouts = 3;

  /// Undo() may take this many times `timeout`. The GCM gives all orders within five times
  /// `timeout`, however many components must run again. The sixth is for stopping them if one
  /// fails.
  static constexpr int kUndoTimeouts = 6;

  /// ExecuteLifecycleOrder() may take this many times `timeout`: once to execute, once to report.
  static constexpr int kLifecycleOrderTimeouts = 2;

  /// ExecuteProcessOrder() may take this many times `timeout`: to start or end the process, to wait
  /// until it joins or to kill it, and to report.
  static constexpr int kProcessOrderTimeouts = 5;

  /// The client and its GCM.
  struct Options {
    std::string name = "viewer";  ///< in the GCM's history and log: "gcm connect", "gcm-gui"
    std::string address;          ///< address of the GCM
    /// Longer than the GCM waits for a process, so that the GCM can report its answer.
    std::chrono::milliseconds timeout{2000};
    /// With Role::kViewer, the client gives up its other rights: the GCM and all processes refuse
    /// its changes.
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
  /// Calls `read` with the current catalogue, without a copy. The client is locked during the call,
  /// so `read` must be short and must not use the client.
  void WithCatalogue(const std::function<void(const Catalogue&)>& read) const;

  /// Asks the GCM for the whole catalogue again; the listener gets it. Does nothing if such a
  /// request is pending or there is no GCM.
  void Resync();

  using ConnectHandler = std::function<void(Result<ConnectionDescription>)>;
  using DoneHandler = std::function<void(Result<void>)>;
  using TextHandler = std::function<void(Result<std::string>)>;

  /// Connects a required interface; this is one step of the history. If the interface is already
  /// connected, WhenConnected::kRefuse refuses the request, and WhenConnected::kReplace first ends
  /// the old connection. The GCM restores the old connection if the new one is refused, or if the
  /// old one was active and the new one is not.
  void Connect(const InterfaceName& required, const InterfaceName& provided, ConnectHandler handler,
               WhenConnected when_connected = WhenConnected::kRefuse);
  void Disconnect(const InterfaceName& required, DoneHandler handler);
  /// Gives an order for the lifecycle of a component, or to load a plug-in. May take twice
  /// `order.patience`, which is `timeout` by default. The order is only valid for the process
  /// instance that is in the catalogue now.
  void ExecuteLifecycleOrder(const message::LifecycleOrder& order, DoneHandler handler);
  /// Starts an `lcm` on the GCM's host, or ends one that the GCM started. May take
  /// kProcessOrderTimeouts times as long as other requests.
  void ExecuteProcessOrder(message::ProcessOrder order, DoneHandler handler);
  /// The processes that the GCM has started. A GCM that is older than this request answers kDenied.
  void GetChildren(std::function<void(Result<message::Children>)> handler);
  /// The classes from which a process can create components, and the plug-ins that it could load.
  void GetClasses(const std::string& process,
                  std::function<void(Result<message::Classes>)> handler);
  using StepHandler = std::function<void(Result<message::HistoryEntry>)>;
  /// Undoes the newest step. If `step` is not 0, the request is refused unless the newest step has
  /// this number.
  void Undo(StepHandler handler, std::uint64_t step = 0);
  /// Skips the newest step, so that earlier steps can be undone. Refused with kFailed if the
  /// process of the step may come back. Also refused if the step could be undone, unless `step` is
  /// its number.
  void PassOver(StepHandler handler, std::uint64_t step = 0);
  /// Reserves the execution of plans for this client, until ReleasePlanLock() or the end of the
  /// link. If another client has it, fails with kFailed, and the error names that client.
  void TakePlanLock(DoneHandler handler);
  void ReleasePlanLock();
  void GetHistory(std::function<void(Result<message::History>)> handler);
  /// The resources that processes use, as last reported to the GCM.
  void GetHealth(std::function<void(Result<message::SystemHealth>)> handler);
  /// The version of a process, or of the GCM if `process` is empty. kDenied from a program that is
  /// older than this request; kFailed if the program cannot be reached or refuses the link.
  void GetVersion(const std::string& process,
                  std::function<void(Result<message::ProgramVersion>)> handler);
  /// The counts of the connection of a required interface, from its process. kNotFound if there is
  /// no connection; kFailed if it is not active.
  void GetCounts(const InterfaceName& required,
                 std::function<void(Result<ConnectionCounts>)> handler);
  /// The counts of a connection at the provided side: capacity and lost events. kNotFound if the
  /// provider's process does not have the connection.
  void GetProviderCounts(const message::Wire& wire,
                         std::function<void(Result<ConnectionCounts>)> handler);
  /// The fill levels of a component's mailboxes.
  void GetFill(const std::string& process, const std::string& component,
               std::function<void(Result<MailboxFill>)> handler);
  /// Removes from the catalogue a process that is lost or has left.
  void Forget(const std::string& process, DoneHandler handler);

  /// From now on, the listener gets the log of all processes: first the newest records that the GCM
  /// has kept, then each new record within about 100 ms. Continues after a broken link, and with a
  /// restarted GCM, which receives the records logged meanwhile.
  void WatchLog();
  /// From now on, the process drops records below `level`. kNotFound for an unknown process;
  /// kFailed if the process is gone.
  void SetLogLevel(const std::string& process, LogLevel level, DoneHandler handler);

  /// Calls any command of a process by its path: reads, qualified reads, void and write commands
  /// alike. `argument` is JSON (empty for none), and so is the answer ("" for none).
  void Call(const std::string& path, const std::string& argument, TextHandler handler);

  using ListenerId = std::uint64_t;
  /// The sink gets the events of any process as they are raised, until StopListening(). Reconnects
  /// by itself. A component never waits for its listeners; events that do not fit into the queue
  /// are lost and counted.
  ListenerId Listen(const EventSubscription& events, std::shared_ptr<EventSink> sink);
  /// After the return, the sink is not called any more. Must not be called from a sink.
  void StopListening(ListenerId id);

  /// The schema of a payload type as a process knows it, by fingerprint; cached.
  void GetSchema(const std::string& process, Fingerprint fingerprint,
                 std::function<void(Result<Schema>)> handler);

  /// Fetches the schemas of types that share a name with another type of the catalogue, so that
  /// FindSchema() knows them and Compare() can name the difference. Call it after every change; it
  /// checks the catalogue at most twice a second.
  void LearnConflictingTypes(DoneHandler handler);

  /// Gives access to state-table rows of any process.
  [[nodiscard]] TelemetryClient& telemetry();

 private:
  class Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

/// Waits for the answer of one of the functions above: `Wait<ConnectionDescription>(timeout,
/// [&](auto handler) { client.Connect(a, b, handler); })`. kTimeout if no answer comes in time; the
/// request may still be executed. Must not be called from a handler.
template <typename T, typename Start>
Result<T> Wait(std::chrono::milliseconds timeout, Start&& start) {
  const auto answer = std::make_shared<std::promise<Result<T>>>();
  auto arrival = answer->get_future();
  std::forward<Start>(start)(std::function<void(Result<T>)>(
      [answer](Result<T> result) { answer->set_value(std::move(result)); }));
  if (arrival.wait_for(timeout) == std::future_status::ready) return arrival.get();
  return Error{ErrorCode::kTimeout, "no answer within " + std::to_string(timeout.count()) +
                                        " ms; it is unknown whether the request was executed"};
}

}  // namespace tendon
