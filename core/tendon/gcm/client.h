#pragma once

#include <tendon/gcm/catalog.h>
#include <tendon/gcm/event_sink.h>
#include <tendon/gcm/messages.h>
#include <tendon/gcm/supervisor/children_messages.h>
#include <tendon/process/program_messages.h>
#include <tendon/process/telemetry_client.h>
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
  std::uint64_t lost = 0;   ///< records before these that the GCM could not keep until we read
  bool is_current = false;  ///< what the GCM had when it was asked is here
};

/// What a viewer hears from a GCM, in a thread of the middleware or the client's own; must not
/// block. The window turns each into a queued signal.
class GcmListener {
 public:
  virtual ~GcmListener() = default;
  /// The whole catalogue: after the first connect, after a gap, after the GCM came back.
  virtual void OnSnapshot(const Catalog& catalog) = 0;
  /// The next changes, which fit what was heard before without a hole.
  virtual void OnChanges(const std::vector<CatalogChange>& changes) = 0;
  /// The GCM cannot be reached; the client tries again by itself, every second.
  virtual void OnGcmLost(const Error& reason) = 0;
  /// After GcmClient::WatchLog(). Texts and sources are printable.
  virtual void OnLog(const LogBatch& /*batch*/) {}
};

/// A viewer's end: watches a GCM's catalogue, asks it for changes of the system, and talks to the
/// processes directly for data. Heals by itself. Functions with a handler return at once and call
/// it exactly once, in a thread of the middleware; the others wait for at most `timeout` and must
/// not be called from a handler.
class GcmClient {
 public:
  /// Replace() and Undo() may take `timeout` so many times: the GCM gives one order after another,
  /// to break, to make, and where that fails to make again what was there.
  static constexpr int kOrdersOfAReplacement = 3;

  /// Undo() may take `timeout` so many times. However many components are to run again, the GCM
  /// gives all orders within five times it; the last is to stop them where one does not.
  static constexpr int kOrdersOfAnUndo = 6;

  /// Steer() may take `timeout` so many times: to be done, and to be heard of.
  static constexpr int kOrdersOfALife = 2;

  /// SteerProcess() may take `timeout` so many times: to be started or asked to end, to join or be
  /// killed, and to be heard of.
  static constexpr int kOrdersOfAProcess = 5;

  /// Who asks, and whom.
  struct Options {
    std::string name = "viewer";  ///< for the GCM's history and log: "gcm connect", "gcm-gui"
    std::string address;          ///< of the GCM
    /// Longer than the GCM waits for a process, so that it can say what that has answered.
    std::chrono::milliseconds timeout{2000};
    /// Gives up what is not in it: to a viewer, whatever would change something is denied, by the
    /// GCM and by each process.
    Role role = Role::kOperator;
  };

  /// Does not wait for the GCM: see WaitUntilWatching().
  GcmClient(std::shared_ptr<Middleware> middleware, Options options,
            std::shared_ptr<GcmListener> listener = nullptr);
  GcmClient(const GcmClient&) = delete;
  GcmClient& operator=(const GcmClient&) = delete;
  ~GcmClient();

  /// Until the first snapshot is here. kUnreachable: "no GCM at X (refused); start one with: gcm
  /// serve".
  Result<void> WaitUntilWatching();

  /// A copy of the catalogue as it is now.
  [[nodiscard]] Catalog catalog() const;
  /// Lets `look` see the catalogue as it is now, without a copy. The client waits for its end: it
  /// must be short, and ask the client for nothing.
  void Look(const std::function<void(const Catalog&)>& look) const;

  /// Asks the GCM for all of the catalogue anew, which the listener then hears. Nothing happens
  /// where that is under way, or there is no GCM.
  void Resync();

  using ConnectHandler = std::function<void(Result<ConnectionDescription>)>;
  using DoneHandler = std::function<void(Result<void>)>;
  using TextHandler = std::function<void(Result<std::string>)>;

  void Connect(const InterfaceName& required, const InterfaceName& provided,
               ConnectHandler handler);
  /// What the required interface is connected to is disconnected first, and connected again if the
  /// new connection is refused, or works less than it. One step of the history.
  void Replace(const InterfaceName& required, const InterfaceName& provided,
               ConnectHandler handler);
  void Disconnect(const InterfaceName& required, DoneHandler handler);
  /// An order for the life of a component, or to load a plug-in: may take `order.patience` and as
  /// long again; without a patience, it is `timeout`. It is for the process as the catalogue has it
  /// now: one that is started anew meanwhile is not given it.
  void Steer(const message::LifeOrder& order, DoneHandler handler);
  /// Starts an `lcm` on the GCM's host, or ends one that it has started: may take
  /// kOrdersOfAProcess times as long as other requests.
  void SteerProcess(message::ProcessOrder order, DoneHandler handler);
  /// The processes that the GCM has started. kDenied by a GCM that is older than the question.
  void GetChildren(std::function<void(Result<message::Children>)> handler);
  /// Of which classes a process makes components, and which plug-ins it could load.
  void GetClasses(const std::string& process,
                  std::function<void(Result<message::Classes>)> handler);
  using StepHandler = std::function<void(Result<message::HistoryEntry>)>;
  /// Takes back the newest step; where `step` is not 0, only if it is that one.
  void Undo(StepHandler handler, std::uint64_t step = 0);
  /// Leaves the newest step as it is, for good, so that those before it can be undone; kFailed
  /// where that can be undone itself and is not named by `step`, or its process may come back.
  void PassOver(StepHandler handler, std::uint64_t step = 0);
  /// That nobody else carries out a plan until it is given back, or the link ends; kFailed says who
  /// does.
  void TakePlanTurn(DoneHandler handler);
  void GivePlanTurnBack();
  void GetHistory(std::function<void(Result<message::History>)> handler);
  /// What processes take of their machines, as they have told the GCM last.
  void GetHealth(std::function<void(Result<message::SystemHealth>)> handler);
  /// Of a process, or of the GCM where it is empty. kDenied by a program that is older than the
  /// question; kFailed where it is not reached, or does not let us in.
  void GetVersion(const std::string& process,
                  std::function<void(Result<message::ProgramVersion>)> handler);
  /// How the connection of a required interface does, as its process knows. kNotFound, kFailed
  /// where it does not stand.
  void GetCounts(const InterfaceName& required,
                 std::function<void(Result<ConnectionCounts>)> handler);
  /// What the process of the provided interface has of a connection to another process: its
  /// capacity and lost events. kNotFound where it has none.
  void GetServed(const message::Wire& wire, std::function<void(Result<ConnectionCounts>)> handler);
  /// How full the mailboxes of a component are.
  void GetFill(const std::string& process, const std::string& component,
               std::function<void(Result<MailboxFill>)> handler);
  /// Removes a tombstone.
  void Forget(const std::string& process, DoneHandler handler);

  /// The listener hears the log of all processes as long as the client lives: first the newest
  /// records, which the GCM has kept, then each within some 100 ms. After the link broke it goes on
  /// where it was; a GCM that was started anew has what was logged in the meantime.
  void WatchLog();
  /// What is below `level` the process drops from now on. kNotFound, kFailed where it is gone.
  void SetLogLevel(const std::string& process, LogLevel level, DoneHandler handler);

  /// Calls a command of any process by its path: `argument` is JSON (empty for none), the answer is
  /// JSON ("" for none). Reads, qualified reads, void and write commands alike.
  void Call(const std::string& path, const std::string& argument, TextHandler handler);

  using ListenerId = std::uint64_t;
  /// The sink hears the events of any process as they are raised, until StopListening(). Heals by
  /// itself. A component never waits for its listeners: what finds no room is counted.
  ListenerId Listen(const EventSubscription& events, std::shared_ptr<EventSink> sink);
  /// After it returns the sink hears nothing more. Not from a sink's function.
  void StopListening(ListenerId id);

  /// The schema of a payload type as a process knows it, by fingerprint; cached.
  void GetSchema(const std::string& process, Fingerprint fingerprint,
                 std::function<void(Result<Schema>)> handler);

  /// Asks for what Compare() must know to say in what two types of one name differ, anywhere in the
  /// catalogue; FindSchema() knows it afterwards, as far as the processes answer. May be called at
  /// every change: the catalogue is looked at twice a second at most.
  void LearnDisputedTypes(DoneHandler handler);

  /// State-table rows of any process: see TelemetryClient.
  [[nodiscard]] TelemetryClient& telemetry();

 private:
  class Implementation;
  const std::unique_ptr<Implementation> implementation_;
};

/// Waits for the answer of one of the functions above: `Wait<ConnectionDescription>(timeout,
/// [&](auto handler) { client.Connect(a, b, handler); })`. kTimeout when it does not come in time;
/// it may still be carried out. Not from a handler.
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
