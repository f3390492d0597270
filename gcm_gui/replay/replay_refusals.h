#pragma once

#include <gcm_gui/recording/recording_runner.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/system_reports.h>
#include <gcm_gui/session/system_requests.h>
#include <gcm_gui/system/plan_runner.h>

#include <QString>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace tendon::gui {

/// Returns the reason why nothing can be changed: "this window shows the recording run.mcap:
/// nothing in it can be changed".
[[nodiscard]] QString ReplayRefusal(const QString& file);

/// Refuses all changes of a recorded system. Answers requests that need only its catalogue and its
/// types.
class ReplayRefusals final : public QObject,
                             public SystemActions,
                             public CommandCalls,
                             public ConnectionChecks,
                             public PlanRunner {
  Q_OBJECT

 public:
  /// `store` must outlive this object.
  ReplayRefusals(QString reason, const CatalogueStore& store)
      : reason_(std::move(reason)), store_(store) {}

  void setTypes(const std::vector<Schema>& types);

  void connectInterfaces(const InterfaceName& required, const InterfaceName& provided) override;
  void connectOrReplace(const InterfaceName& required, const InterfaceName& provided) override;
  void disconnectInterface(const InterfaceName& required) override;
  void undo() override;
  void forget(const std::string& process) override;
  void executeLifecycleOrder(LifecycleVerb verb, const std::string& process,
                             const std::string& component) override;
  void setLogLevel(const std::string& process, LogLevel level) override;

  void findSchema(const std::string& process, Fingerprint type, SchemaHandler handler) override;
  void callCommand(const std::string& path, const std::string& argument,
                   ResultHandler handler) override;
  void readValue(const std::string& path, ValueHandler handler) override;

  void diagnose(const message::ConnectionEnds& ends, DiagnosisHandler handler) override;

  void carryOut(Plan plan, AfterError after_error, Progress progress, Done done) override;
  // Functions of PlanRunner. No plan is ever executed.
  void stop() override {}

 Q_SIGNALS:
  /// One sentence for the user.
  void notice(const QString& text);

 private:
  [[nodiscard]] Error refusal() const;

  const QString reason_;
  const CatalogueStore& store_;
  std::map<Fingerprint, Schema> types_;
};

/// Reports only the log and the events of a recording; refuses all other requests.
class ReplayReports final : public SystemReports {
  Q_OBJECT

 public:
  explicit ReplayReports(QString reason) : reason_(std::move(reason)) {}

  void watchLog() override {}
  void listen(const QObject* /*owner*/, const QStringList& /*patterns*/) override {}
  void askHealth(Handler<message::SystemHealth> handler) override;
  void askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) override;
  void askFill(const std::string& process, const std::string& component,
               Handler<MailboxFill> handler) override;
  void askHistory(const std::string& process,
                  Handler<message::ProcessHistoryState> handler) override;
  void askChildren(Handler<message::Children> handler) override;
  void askClasses(const std::string& process, Handler<message::Classes> handler) override;

 private:
  template <typename T>
  void refuse(Handler<T> handler);

  const QString reason_;
};

/// Refuses all recordings, because this window shows a recording.
class ReplayRecordings final : public RecordingRunner {
  Q_OBJECT

 public:
  explicit ReplayRecordings(QString reason) : reason_(std::move(reason)) {}

  void start(const RecordingRequest& /*request*/) override { Q_EMIT refused(reason_); }
  void stop() override {}

 private:
  const QString reason_;
};

}  // namespace tendon::gui
