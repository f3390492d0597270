#include <gcm_gui/session/gcm_session.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/gcm/diagnosis.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/text.h>

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

double SecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <typename T>
std::optional<Error> ErrorOf(const Result<T>& result) {
  return result.ok() ? std::nullopt : std::optional(result.error());
}

/// Returns the action of a window that corresponds to a step in the history of the GCM.
Action ActionOf(const message::HistoryEntry& step) {
  Action action;
  if (IsLifecycleStep(step)) {
    action.verb = Action::Verb::kUndo;  // for a step that a window cannot make
    action.component = step.lifecycle.process + '/' + step.lifecycle.component;
    for (const LifecycleVerb verb :
         {LifecycleVerb::kStart, LifecycleVerb::kSuspend, LifecycleVerb::kStop}) {
      if (ToString(verb) != step.verb) continue;
      action.verb = Action::Verb::kLifecycle;
      action.lifecycle_verb = verb;
    }
    return action;
  }
  action.verb = step.verb == "connect"   ? Action::Verb::kConnect
                : step.verb == "replace" ? Action::Verb::kReplace
                                         : Action::Verb::kDisconnect;
  action.required = step.ends.required;
  action.provided = step.ends.provided;
  return action;
}

}  // namespace

class GcmSession::Listener final : public GcmListener {
 public:
  Listener(GcmSession& session, std::shared_ptr<GuiPoster> poster)
      : session_(session), poster_(std::move(poster)) {}

  void OnSnapshot(const Catalogue& catalogue) override {
    poster_->post([this, catalogue] { session_.onSnapshot(catalogue); });
  }
  void OnChanges(const std::vector<CatalogueChange>& changes) override {
    poster_->post([this, changes] { session_.onChanges(changes); });
  }
  void OnGcmLost(const Error& reason) override {
    poster_->post([this, reason] { session_.onLinkLost(reason); });
  }
  void OnLog(const LogBatch& batch) override {
    poster_->post([this, batch] { Q_EMIT session_.reports_->logArrived(batch); });
  }

 private:
  // Used only in the thread of the session, and only while the session exists.
  GcmSession& session_;
  std::shared_ptr<GuiPoster> poster_;
};

GcmSession::GcmSession(std::shared_ptr<Middleware> middleware, const std::string& address,
                       bool hosted, Role role, std::chrono::milliseconds timeout)
    : undo_choice_(NameOfThisWindow()), poster_(std::make_shared<GuiPoster>(this)) {
  link_.setAddress(ToQString(address), hosted);
  GcmClient::Options options;
  options.name = NameOfThisWindow();
  options.address = address;
  options.role = role;
  options.timeout = timeout;
  client_ =
      std::make_shared<GcmClient>(middleware, options, std::make_shared<Listener>(*this, poster_));
  live_signals_ = std::make_unique<LiveSignals>(client_->telemetry());
  reports_ = std::make_unique<NetworkReports>(*client_, store_, poster_);
  plans_ = std::make_unique<PlanWorker>(client_, options.timeout);
  options.role = Role::kViewer;  // a recording changes nothing
  recordings_ = std::make_unique<RecordingWorker>(std::move(middleware), options);
  connect(&link_, &LinkState::resyncRequested, this, [this] { client_->Resync(); });
}

GcmSession::~GcmSession() {
  poster_->detach();
  recordings_.reset();
  plans_.reset();
  live_signals_.reset();
  reports_.reset();
  client_.reset();
}

void GcmSession::onSnapshot(const Catalogue& catalogue) {
  store_.replace(catalogue);
  failCallsToLostProcesses();
  link_.setConnected();
  learnTypes();
}

void GcmSession::onChanges(const std::vector<CatalogueChange>& changes) {
  store_.apply(changes);
  failCallsToLostProcesses();
  const auto is_component = [](const CatalogueChange& change) {
    return change.kind == CatalogueChange::Kind::kComponent;
  };
  if (std::any_of(changes.begin(), changes.end(), is_component)) learnTypes();
}

/// Requests types in advance, so that a mismatch can be explained as soon as the user asks.
void GcmSession::learnTypes() {
  client_->LearnConflictingTypes([this, poster = poster_](const auto& /*as far as they answer*/) {
    poster->post([this] { Q_EMIT store_.typesLearned(); });
  });
}

void GcmSession::onLinkLost(const Error& reason) {
  link_.setUnreachable(ToQString(reason.message));
}

GcmSession::Finish GcmSession::begin(Action action) {
  const ActivityModel::Id id = activity_.begin(std::move(action));
  const auto start = std::chrono::steady_clock::now();
  return [this, poster = poster_, id, start](const std::optional<Error>& refusal) {
    const double seconds = SecondsSince(start);
    poster->post([this, id, seconds, refusal] { finish(id, seconds, refusal); });
  };
}

void GcmSession::finish(ActivityModel::Id id, double seconds, const std::optional<Error>& refusal) {
  QString text;
  if (refusal) {
    text = refusal->message.empty() ? ToQString(tendon::ToString(refusal->code))
                                    : ToQString(refusal->message);
  }
  activity_.finish(id, seconds, text);
}

void GcmSession::connectInterfaces(const InterfaceName& required, const InterfaceName& provided) {
  Action action;
  action.verb = Action::Verb::kConnect;
  action.required = required;
  action.provided = provided;
  client_->Connect(required, provided, [finish = begin(std::move(action))](const auto& result) {
    finish(ErrorOf(result));
  });
}

void GcmSession::connectOrReplace(const InterfaceName& required, const InterfaceName& provided) {
  if (store_.catalogue().FindConnection(required) == nullptr) {
    return connectInterfaces(required, provided);
  }
  Action action;
  action.verb = Action::Verb::kReplace;
  action.required = required;
  action.provided = provided;
  client_->Connect(
      required, provided,
      [finish = begin(std::move(action))](const auto& result) { finish(ErrorOf(result)); },
      WhenConnected::kReplace);
}

void GcmSession::disconnectInterface(const InterfaceName& required) {
  Action action;
  action.verb = Action::Verb::kDisconnect;
  action.required = required;
  client_->Disconnect(required, [finish = begin(std::move(action))](const auto& result) {
    finish(ErrorOf(result));
  });
}

void GcmSession::undo() {
  Action action;
  action.verb = Action::Verb::kUndo;
  const ActivityModel::Id id = activity_.begin(std::move(action));
  const auto start = std::chrono::steady_clock::now();
  client_->GetHistory([this, poster = poster_, id, start](const auto& history) {
    poster->post([this, id, start, history] {
      const Result<std::uint64_t> step =
          history ? undo_choice_.Choose(*history, std::chrono::steady_clock::now(), WallClock())
                  : Result<std::uint64_t>(history.error());
      if (!step) return finish(id, SecondsSince(start), step.error());
      undoStep(id, start, *step);
    });
  });
}

void GcmSession::undoStep(ActivityModel::Id id, std::chrono::steady_clock::time_point start,
                          std::uint64_t step) {
  const auto on_reply = [this, poster = poster_, id, start](const auto& result) {
    poster->post([this, id, start, result] {
      finish(id, SecondsSince(start), ErrorOf(result));
      if (!result.ok()) return;
      activity_.markUndone(id, ActionOf(*result));
    });
  };
  client_->Undo(on_reply, step);
}

void GcmSession::forget(const std::string& process) {
  Action action;
  action.verb = Action::Verb::kForget;
  action.process = process;
  client_->Forget(process, [finish = begin(std::move(action))](const auto& result) {
    finish(ErrorOf(result));
  });
}

void GcmSession::executeLifecycleOrder(LifecycleVerb verb, const std::string& process,
                                       const std::string& component) {
  Action action;
  action.verb = Action::Verb::kLifecycle;
  action.lifecycle_verb = verb;
  action.component = process + '/' + component;
  client_->ExecuteLifecycleOrder(
      {.verb = verb, .process = process, .component = component},
      [finish = begin(std::move(action))](const auto& result) { finish(ErrorOf(result)); });
}

void GcmSession::setLogLevel(const std::string& process, LogLevel level) {
  Action action;
  action.verb = Action::Verb::kLogLevel;
  action.process = process;
  action.argument = ToQString(tendon::ToString(level));
  client_->SetLogLevel(process, level, [finish = begin(std::move(action))](const auto& result) {
    finish(ErrorOf(result));
  });
}

void GcmSession::findSchema(const std::string& process, Fingerprint type, SchemaHandler handler) {
  client_->GetSchema(process, type, [poster = poster_, handler](const auto& schema) {
    poster->post([handler, schema] { handler(schema); });
  });
}

void GcmSession::callCommand(const std::string& path, const std::string& argument,
                             ResultHandler handler) {
  Action action;
  action.verb = Action::Verb::kCall;
  action.command = ToQString(path);
  action.argument = ToQString(argument);
  const ActivityModel::Id id = activity_.begin(std::move(action));
  pending_calls_[id] = {path.substr(0, path.find('/')), std::chrono::steady_clock::now(),
                        std::move(handler)};
  client_->Call(path, argument, [this, poster = poster_, id](const auto& result) {
    poster->post([this, id, result] { finishCall(id, result); });
  });
}

void GcmSession::readValue(const std::string& path, ValueHandler handler) {
  client_->Call(path, {}, [poster = poster_, handler](const auto& value) {
    poster->post([handler, value] { handler(value); });
  });
}

void GcmSession::finishCall(ActivityModel::Id id, const Result<std::string>& result) {
  const auto call = pending_calls_.extract(id);
  if (call.empty()) return;
  const double seconds = SecondsSince(call.mapped().start);
  finish(id, seconds, ErrorOf(result));
  call.mapped().handler(result, seconds);
}

void GcmSession::failCallsToLostProcesses() {
  std::vector<std::pair<ActivityModel::Id, Error>> lost;
  for (const auto& [id, call] : pending_calls_) {
    const ProcessEntry* entry = store_.catalogue().FindProcess(call.process);
    if (entry == nullptr || entry->process.state != ProcessState::kLost) continue;
    const std::string reason =
        entry->process.reason.empty() ? "" : " (" + entry->process.reason + ")";
    const QString sentence =
        Words::tr(
            "process '%1' is lost%2; it is unknown whether the command was "
            "executed or will still be executed: check the component before you "
            "repeat the call")
            .arg(ToQString(call.process), ToQString(reason));
    lost.emplace_back(id, Error{ErrorCode::kTimeout, sentence.toStdString()});
  }
  for (const auto& [id, error] : lost) finishCall(id, error);
}

void GcmSession::diagnose(const message::ConnectionEnds& ends, DiagnosisHandler handler) {
  const Catalogue& catalogue = store_.catalogue();
  const Result<Diagnosis> diagnosis = Diagnose(catalogue, ends);
  if (!diagnosis) return poster_->post([handler, diagnosis] { handler(diagnosis); });
  const auto report = [this, poster = poster_, handler](Diagnosis complete,
                                                        const Result<ConnectionCounts>& served) {
    poster->post([this, handler, complete, served]() mutable {
      AddActivity(complete, store_.catalogue());
      if (complete.failure) AddRemnants(complete, store_.catalogue(), served);
      handler(complete);
    });
  };
  if (diagnosis->failure) {
    const auto* provider = catalogue.FindProcess(ends.provided.process);
    const auto present = provider != nullptr ? RequirePresent(provider->process) : Result<void>();
    if (diagnosis->is_connected) return report(*diagnosis, ConnectionCounts());
    if (!present) return report(*diagnosis, present.error());
    return client_->GetProviderCounts(
        ends, [report, diagnosis](const auto& served) { report(*diagnosis, served); });
  }
  const auto start = std::chrono::steady_clock::now();
  const auto on_reply = [report, diagnosis, start](const auto& result) {
    const auto end = std::chrono::steady_clock::now();
    auto complete = *diagnosis;
    const bool answers = result.ok() || result.error().code == ErrorCode::kNotFound;
    AddRoundTrip(complete,
                 answers ? Result<std::chrono::microseconds>(
                               std::chrono::duration_cast<std::chrono::microseconds>(end - start))
                         : Result<std::chrono::microseconds>(result.error()));
    report(complete, answers ? Result<ConnectionCounts>(ConnectionCounts()) : result.error());
  };
  // The process itself answers this request, without a thread of the component.
  client_->GetFill(ends.provided.process, ends.provided.component, on_reply);
}

}  // namespace tendon::gui
