#pragma once

#include <gcm_gui/recording/recording_runner.h>
#include <gcm_gui/session/signal_source.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/session/system_requests.h>
#include <gcm_gui/system/plan_runner.h>
#include <gcm_gui/views/raw_image.h>
#include <tests/core/gcm/argument_samples.h>

#include <QMap>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QUrl>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon::gui {

/// Values of a column of doubles.
std::vector<std::optional<NumericValue>> ExactValues(const std::vector<double>& values);

/// Records the requested actions: "connect a b", "connect if free a b", "disconnect a", "undo",
/// "forget a", "stop robot/arm".
class RecordingActions final : public SystemActions {
 public:
  void connectInterfaces(const InterfaceName& required, const InterfaceName& provided) override;
  void connectOrReplace(const InterfaceName& required, const InterfaceName& provided) override;
  void disconnectInterface(const InterfaceName& required) override;
  void undo() override { asked.append(QStringLiteral("undo")); }
  void forget(const std::string& process) override;
  void executeLifecycleOrder(LifecycleVerb verb, const std::string& process,
                             const std::string& component) override;
  void setLogLevel(const std::string& process, LogLevel level) override;

  QStringList asked;
};

/// Knows the schema of one type, and records the calls: "robot/arm/Control.MoveTo {...}". The test
/// gives the results.
class ScriptedCalls final : public CommandCalls {
 public:
  void findSchema(const std::string& process, Fingerprint type, SchemaHandler handler) override;
  void callCommand(const std::string& path, const std::string& argument,
                   ResultHandler handler) override;
  void readValue(const std::string& path, ValueHandler handler) override;

  Result<Schema> schema = Error{ErrorCode::kTimeout, "no reply"};
  std::map<Fingerprint, Schema> schemas;  ///< schemas of further types
  int asked_for_schema = 0;
  QStringList calls;
  ResultHandler answer;  ///< the handler of the newest call
  QStringList read;      ///< paths of the read requests
  ValueHandler value;    ///< the handler of the newest read request
};

/// Records the requests; the test answers them.
class ScriptedChecks final : public ConnectionChecks {
 public:
  void diagnose(const message::ConnectionEnds& ends, DiagnosisHandler handler) override;

  std::vector<message::ConnectionEnds> diagnosed;
  DiagnosisHandler diagnosis;  ///< the handler of the newest request
};

/// Records the plan; the test sets the results of its steps.
class ScriptedPlans final : public PlanRunner {
 public:
  void carryOut(Plan wanted, AfterError after, Progress on_step, Done on_end) override {
    plan = std::move(wanted);
    after_error = after;
    progress = std::move(on_step);
    done = std::move(on_end);
    ++started;
  }
  void stop() override { ++stopped; }

  Plan plan;
  AfterError after_error = AfterError::kStop;
  Progress progress;
  Done done;
  int started = 0;
  int stopped = 0;
};

/// Stores the requests; the test answers them with its Qt signals.
class ScriptedRecordings final : public RecordingRunner {
  Q_OBJECT

 public:
  using RecordingRunner::RecordingRunner;

  void start(const RecordingRequest& request) override { requests.push_back(request); }
  void stop() override { ++stopped; }

  std::vector<RecordingRequest> requests;
  int stopped = 0;
};

/// While this object exists, folders to show are passed to it instead of the file manager.
class ScriptedFileManager final : public QObject {
  Q_OBJECT

 public:
  ScriptedFileManager();
  ~ScriptedFileManager() override;

  QStringList shown;

 public Q_SLOTS:
  void show(const QUrl& url) { shown << url.toLocalFile(); }
};

/// Records the requested signals and columns; the test sends rows and values with its Qt signals.
class ScriptedSignals final : public SignalSource {
  Q_OBJECT

 public:
  using SignalSource::SignalSource;

  void subscribe(const QString& signal) override { ++subscribed[signal]; }
  void release(const QString& signal) override {
    if (--subscribed[signal] == 0) subscribed.remove(signal);
  }
  void watch(const QObject* owner, const QSet<QString>& columns) override;
  void retry(const QString& column) override { retried.append(column); }
  [[nodiscard]] RowLosses losses(const QString& /*signal*/) const override { return lost; }

  /// All signals that are watched.
  [[nodiscard]] QSet<QString> watched() const;
  /// Delivers a row of `column` as the newest; `schema` is the type of its value.
  void send(const QString& column, const Schema& schema, const std::vector<double>& values);
  /// Sends a newest row of a column that holds a picture.
  void sendPicture(const QString& column, const RawImage& picture);

  QMap<QString, int> subscribed;
  QStringList retried;
  RowLosses lost;  ///< of every signal

 private:
  QMap<const QObject*, QSet<QString>> watched_;
  QMap<QString, NumericFieldList> shapes_;
};

/// Records the requests; the test gives the replies, and sends log and events with its Qt signals.
class ScriptedReports final : public SystemReports {
  Q_OBJECT

 public:
  using SystemReports::SystemReports;

  void watchLog() override { watches_log = true; }
  void listen(const QObject* owner, const QStringList& patterns) override;
  void askHealth(Handler<message::SystemHealth> handler) override {
    ++health_questions;
    handler(health);
  }
  void askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) override;
  void askFill(const std::string& process, const std::string& component,
               Handler<MailboxFill> handler) override;
  void askHistory(const std::string& /*process*/,
                  Handler<message::ProcessHistoryState> handler) override {
    ++history_questions;
    handler(history);
  }
  void askChildren(Handler<message::Children> handler) override;
  void askClasses(const std::string& process, Handler<message::Classes> handler) override;

  [[nodiscard]] QStringList listened() const;
  /// Sends a record of robot/arm's log, with the present time.
  void sendLog(LogLevel level, const std::string& source, const std::string& text);

  bool watches_log = false;
  int health_questions = 0;
  int history_questions = 0;
  Result<message::SystemHealth> health = message::SystemHealth();
  Result<ConnectionCounts> counts = Error{ErrorCode::kNotFound, "nothing is known"};
  QStringList counted;         ///< the connections whose counts were requested
  bool answers_counts = true;  ///< true: answers at once; false: the test answers
  std::vector<Handler<ConnectionCounts>> count_handlers;  ///< handlers that the test must call
  Result<MailboxFill> fill = MailboxFill();
  Result<message::ProcessHistoryState> history = message::ProcessHistoryState();
  /// The reply; if empty, the request is never answered.
  std::optional<Result<message::Children>> children = message::Children();
  QStringList asked_for_classes;  ///< the processes that were asked for their classes
  std::vector<Handler<message::Classes>> class_handlers;  ///< handlers that the test must call

 private:
  QMap<const QObject*, QStringList> wanted_;
};

/// Returns a schema with period, lateness, compute (in s) and overruns.
Schema CycleSchema();
/// The values of a row of `CycleSummary`; all times in s.
struct SummaryValues {
  double cycles = 0;
  double period = 0;
  double late = 0;
  double later = 0;
  double latest = 0;
  double compute = 0;
};
void SendSummary(ScriptedSignals& source, const QString& component, const SummaryValues& values);

}  // namespace tendon::gui
