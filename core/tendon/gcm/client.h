#pragma once

#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/event_sink.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/middleware/middleware.h>
#include <tendon/process/history/history_messages.h>
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

/// The next log records of all processes, oldest first.
struct LogBatch {
  std::vector<message::LogRecord> records{};
  std::uint64_t lost = 0;  ///< number of earlier records that the GCM had already dropped
  /// True if the listener now has all records that the GCM had at the time of the request.
  bool is_current = false;
};

/// Receives the events of a GCM, in a thread of the middleware or of the client; must not block.
/// The window turns each of these calls into a queued signal.
class GcmListener {
 public:
  virtual ~GcmListener() = default;
  /// Called with the whole catalogue when the GCM is reached for the first time or again, and after
  /// a gap in the changes.
  virtual void OnSnapshot(const Catalogue& catalogue) = 0;
  /// Called with the next changes. No change is missing between them and the previous ones.
  virtual void OnChanges(const std::vector<CatalogueChange>& changes) = 0;
  /// Called when the GCM cannot be reached. The client tries again every second.
  virtual void OnGcmLost(const Error& reason) = 0;
  /// Called after GcmClient::WatchLog(). Texts and sources are printable.
  virtual void OnLog(const LogBatch& /*batch*/) {}
};

/// A viewer's connection to a system. It watches a GCM's catalogue, asks the GCM for changes, and
/// exchanges data with the processes directly. Reconnects automatically.
///
/// Functions with a handler return at once, and call the handler exactly once, in a thread of the
/// middleware. Functions without a handler wait for at most `timeout` and must not be called from a
/// handler.
class GcmClient {
 public:
  /// A Connect() with WhenConnected::kReplace may take this many times `timeout`: the GCM ends the
  /// old connection, makes the new connection, and restores the old one if this fails.
  static constexpr int kReplaceTimeouts = 3;

  /// Undo() may take this many times `timeout`. The GCM sends all orders within five times
  /// `timeout`, even if many components must be started again. If a start fails, the GCM needs one
  /// more `timeout` to stop the components again.
  static constexpr int kUndoTimeouts = 6;

  /// ExecuteLifecycleOrder() may take this many times `timeout`: one for the execution of the
  /// order, one for the report of its outcome.
  static constexpr int kLifecycleOrderTimeouts = 2;

  /// ExecuteProcessOrder() may take this many times `timeout`. The GCM starts a process and waits
  /// until it joins, or terminates a process, kills it if necessary, and then reports.
  static constexpr int kProcessOrderTimeouts = 5;

  /// The options of a client.
  struct Options {
    /// The name of this program in the GCM's history and log: "gcm connect", "gcm-gui".
    std::string name = "viewer";
    std::string address{};  ///< address of the GCM
    /// The time to wait for a reply. It must be longer than the time that the GCM waits for a
    /// process, so that the GCM can forward the reply of the process.
    std::chrono::milliseconds timeout{2000};
    /// The role of this client. With Role::kViewer, the GCM and all processes refuse changes by
    /// this client.
    Role role = Role::kOperator;
  };

  /// Returns before the GCM is reached; see WaitUntilWatching().
  GcmClient(std::shared_ptr<Middleware> middleware, Options options,
            std::shared_ptr<GcmListener> listener = nullptr);
  GcmClient(const GcmClient&) = delete;
  GcmClient& operator=(const GcmClient&) = delete;
  ~GcmClient();

  /// Waits for the first snapshot. Fails with kUnreachable if there is no GCM: "no GCM at X
  /// (refused); start one with: gcm serve".
  Result<void> WaitUntilWatching();

  /// Returns a copy of the current catalogue.
  [[nodiscard]] Catalogue catalogue() const;
  /// Calls `read` with the current catalogue, without a copy. The client is locked during the call,
  /// so `read` must be short and must not use the client.
  void WithCatalogue(const std::function<void(const Catalogue&)>& read) const;

  /// Asks the GCM for the whole catalogue again. The listener receives it with OnSnapshot(). Does
  /// nothing if such a request is already pending or the GCM is not reached.
  void Resync();

  using ConnectHandler = std::function<void(Result<ConnectionDescription>)>;
  using DoneHandler = std::function<void(Result<void>)>;
  using TextHandler = std::function<void(Result<std::string>)>;

  /// Connects a required interface, as one step of the history. If the interface is already
  /// connected, WhenConnected::kRefuse refuses the request. WhenConnected::kReplace first ends the
  /// old connection. The GCM restores the old connection if the new one is refused, or if the old
  /// one was active and the new one is not.
  void Connect(const InterfaceName& required, const InterfaceName& provided, ConnectHandler handler,
               WhenConnected when_connected = WhenConnected::kRefuse);
  void Disconnect(const InterfaceName& required, DoneHandler handler);
  /// Sends an order for the lifecycle of a component, or an order to load a plug-in. May take twice
  /// `order.timeout`; if `order.timeout` is 0, `timeout` is used instead. If `order.instance` is
  /// 0, the order is valid only for the process instance that is in the catalogue now.
  void ExecuteLifecycleOrder(const message::LifecycleOrder& order, DoneHandler handler);
  /// Starts an `lcm` on the GCM's host, or ends an `lcm` that the GCM started. May take
  /// kProcessOrderTimeouts times `timeout`.
  void ExecuteProcessOrder(message::ProcessOrder order, DoneHandler handler);
  /// Gets the processes that the GCM has started.
  void GetChildren(std::function<void(Result<message::Children>)> handler);
  /// Gets the classes from which a process can create components, and the plug-ins that the process
  /// could load.
  void GetClasses(const std::string& process,
                  std::function<void(Result<message::Classes>)> handler);
  using StepHandler = std::function<void(Result<message::HistoryEntry>)>;
  /// Undoes the newest step. Refuses the request if `step` is neither 0 nor the number of the
  /// newest step.
  void Undo(StepHandler handler, std::uint64_t step = 0);
  /// Marks the newest step as skipped, so that earlier steps can be undone. Fails with kFailed if
  /// the process of the step is lost but may come back. If the step could be undone, `step` must be
  /// its number; with 0, also fails with kFailed.
  void SkipNewestStep(StepHandler handler, std::uint64_t step = 0);
  /// Takes the plan lock, which allows only this client to execute plans. The lock is held until
  /// ReleasePlanLock(), or until the link to the GCM ends. Fails with kFailed if another client has
  /// the lock; the error names that client.
  void TakePlanLock(DoneHandler handler);
  void ReleasePlanLock();
  void GetHistory(std::function<void(Result<message::History>)> handler);
  /// Gets the last report of each process about the resources that it uses.
  void GetHealth(std::function<void(Result<message::SystemHealth>)> handler);
  /// Gets the version of a process, or of the GCM if `process` is empty.
  void GetVersion(const std::string& process,
                  std::function<void(Result<message::ProgramVersion>)> handler);
  /// Gets the counts of the connection of a required interface from the process that has this
  /// interface. Fails with kNotFound if there is no connection, and with kFailed if the connection
  /// is not active.
  void GetCounts(const InterfaceName& required,
                 std::function<void(Result<ConnectionCounts>)> handler);
  /// Gets the counts of a connection from the provider's process, but only the capacity and the
  /// lost events. Fails with kNotFound if that process does not have the connection.
  void GetProviderCounts(const message::ConnectionEnds& ends,
                         std::function<void(Result<ConnectionCounts>)> handler);
  /// Gets the fill levels of a component's mailboxes.
  void GetFill(const std::string& process, const std::string& component,
               std::function<void(Result<MailboxFill>)> handler);
  /// Gets the amount of history that a process keeps.
  void GetProcessHistory(const std::string& process,
                         std::function<void(Result<message::ProcessHistoryState>)> handler);
  /// Reads a page of the log that a process has kept itself. Fails with kFailed if its history is
  /// off.
  void ReadLog(const std::string& process, const message::ReadLog& wanted,
               std::function<void(Result<message::ReadLogReply>)> handler);
  /// Removes from the catalogue a process that is lost or has left.
  void Forget(const std::string& process, DoneHandler handler);

  /// From now on, the listener receives the log of all processes: first the newest records that the
  /// GCM has kept, then each new record within about 100 ms. Continues when the link to the GCM is
  /// restored or the GCM is restarted; then the records of the time in between follow.
  void WatchLog();
  /// From now on, the process drops log records below `level`. Fails with kNotFound for an unknown
  /// process, and with kFailed if the process is gone.
  void SetLogLevel(const std::string& process, LogLevel level, DoneHandler handler);

  /// Calls a command of a process by its path: a read, qualified read, void or write command.
  /// `argument` and the reply are JSON, or empty if the command has none.
  void Call(const std::string& path, const std::string& argument, TextHandler handler);

  /// Reads the events that a process has kept and that are not older than `last`, oldest first. The
  /// sink gets OnListening(), then OnEvent(). Then `done` is called once, in a thread of the
  /// middleware or of the client, or before this function returns, if the reading fails at once.
  /// After the end of the client, neither the sink nor `done` is called. Neither of them may
  /// destroy the client. Fails with kFailed if the history of the process is off. No process keeps
  /// past calls of commands.
  void ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds last,
                      std::shared_ptr<EventSink> sink, std::function<void(const PastEvents&)> done);

  using ListenerId = std::uint64_t;
  /// Subscribes to events of a process. The sink receives each event when it is raised, until
  /// StopListening(). Reconnects automatically. A component never waits for its listeners. Events
  /// that do not fit into the queue are lost and counted.
  ListenerId Listen(const EventSubscription& events, std::shared_ptr<EventSink> sink);
  /// Ends a subscription. After this function has returned, the sink is not called any more. Must
  /// not be called from a sink.
  void StopListening(ListenerId id);

  /// Gets the schema of a payload type by its fingerprint from `process`, which must know the type.
  /// The client caches schemas.
  void GetSchema(const std::string& process, Fingerprint fingerprint,
                 std::function<void(Result<Schema>)> handler);

  /// Fetches the schemas of different types in the catalogue that have the same name. Then
  /// FindSchema() knows them, and Compare() can name the difference. Call it after every change; it
  /// checks the catalogue at most twice a second.
  void LearnConflictingTypes(DoneHandler handler);

  /// Gives access to the rows of state tables of any process.
  [[nodiscard]] TelemetryClient& telemetry();

 private:
  class Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

/// Calls one of the functions above and waits for its reply: `Wait<ConnectionDescription>(timeout,
/// [&](auto handler) { client.Connect(a, b, handler); })`. Fails with kTimeout if no reply arrives
/// in time; even then, the request may still be executed. Must not be called from a handler.
template <typename T, typename Start>
Result<T> Wait(std::chrono::milliseconds timeout, Start&& start) {
  const auto reply = std::make_shared<std::promise<Result<T>>>();
  auto arrival = reply->get_future();
  std::forward<Start>(start)(std::function<void(Result<T>)>(
      [reply](Result<T> result) { reply->set_value(std::move(result)); }));
  if (arrival.wait_for(timeout) == std::future_status::ready) return arrival.get();
  return Error{ErrorCode::kTimeout, "no reply within " + std::to_string(timeout.count()) +
                                        " ms; it is unknown whether the request was executed"};
}

}  // namespace tendon
