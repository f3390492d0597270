#pragma once

#include <gcm_gui/activity/activity_model.h>
#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/recording/recording_worker.h>
#include <gcm_gui/session/catalogue_store.h>
#include <gcm_gui/session/link_state.h>
#include <gcm_gui/session/live_signals.h>
#include <gcm_gui/session/network_reports.h>
#include <gcm_gui/session/system_requests.h>
#include <gcm_gui/session/undo_choice.h>
#include <gcm_gui/system/plan_worker.h>
#include <tendon/gcm/client.h>

#include <QObject>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::gui {

/// The window's only connection to the system, and the only class whose handlers are called by
/// network threads. Everything is delivered in the GUI thread, in order. No request blocks.
class GcmSession : public QObject,
                   public SystemActions,
                   public CommandCalls,
                   public ConnectionChecks {
  Q_OBJECT

 public:
  /// Searches for the GCM at `address` without a time limit. Other requests time out after
  /// `timeout`. If the role is viewer, every change is denied.
  GcmSession(std::shared_ptr<Middleware> middleware, const std::string& address, bool hosted,
             Role role = Role::kOperator,
             std::chrono::milliseconds timeout = GcmClient::Options().timeout);
  ~GcmSession() override;

  [[nodiscard]] CatalogueStore& store() { return store_; }
  [[nodiscard]] LinkState& link() { return link_; }
  [[nodiscard]] ActivityModel& activity() { return activity_; }
  [[nodiscard]] LiveSignals& liveSignals() { return *live_signals_; }
  [[nodiscard]] SystemReports& reports() { return *reports_; }
  [[nodiscard]] PlanRunner& plans() { return *plans_; }
  [[nodiscard]] RecordingWorker& recordings() { return *recordings_; }

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

 private:
  class Listener;
  using Finish = std::function<void(const std::optional<Error>&)>;
  /// A call that has not been answered yet.
  struct PendingCall {
    std::string process;
    std::chrono::steady_clock::time_point start;
    ResultHandler handler;
  };

  void onSnapshot(const Catalogue& catalogue);
  void onChanges(const std::vector<CatalogueChange>& changes);
  void onLinkLost(const Error& reason);
  void learnTypes();
  /// Adds the action to the activity list. The caller may pass the result to the returned function
  /// in any thread.
  Finish begin(Action action);
  void undoStep(ActivityModel::Id id, std::chrono::steady_clock::time_point start,
                std::uint64_t step);
  /// Finishes a call in the activity list. Ignored if the call was already given up.
  void finishCall(ActivityModel::Id id, const Result<std::string>& result);
  /// Gives up the calls to lost processes; they count as failed.
  void failCallsToLostProcesses();
  void finish(ActivityModel::Id id, double seconds, const std::optional<Error>& refusal);

  CatalogueStore store_;
  LinkState link_;
  ActivityModel activity_;
  UndoChoice undo_choice_;
  std::map<ActivityModel::Id, PendingCall> pending_calls_;
  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<GcmClient> client_;
  std::unique_ptr<LiveSignals> live_signals_;
  std::unique_ptr<NetworkReports> reports_;
  std::unique_ptr<PlanWorker> plans_;
  std::unique_ptr<RecordingWorker> recordings_;
};

}  // namespace tendon::gui
