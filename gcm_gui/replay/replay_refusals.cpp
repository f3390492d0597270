#include <gcm_gui/replay/replay_refusals.h>

#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/gcm/diagnosis.h>
#include <tendon/payload/fingerprint.h>

#include <QFileInfo>
#include <QTimer>
#include <utility>

namespace tendon::gui {

QString ReplayRefusal(const QString& file) {
  return Words::tr("This window shows the recording %1: nothing in it can be changed")
      .arg(QFileInfo(file).fileName());
}

Error ReplayRefusals::refusal() const { return {ErrorCode::kDenied, reason_.toStdString()}; }

void ReplayRefusals::setTypes(const std::vector<Schema>& types) {
  for (const Schema& type : types) types_.insert_or_assign(payload::Remember(type), type);
}

void ReplayRefusals::connectInterfaces(const InterfaceName& /*required*/,
                                       const InterfaceName& /*provided*/) {
  Q_EMIT notice(reason_);
}

void ReplayRefusals::connectOrReplace(const InterfaceName& /*required*/,
                                      const InterfaceName& /*provided*/) {
  Q_EMIT notice(reason_);
}

void ReplayRefusals::disconnectInterface(const InterfaceName& /*required*/) {
  Q_EMIT notice(reason_);
}

void ReplayRefusals::undo() { Q_EMIT notice(reason_); }

void ReplayRefusals::forget(const std::string& /*process*/) { Q_EMIT notice(reason_); }

void ReplayRefusals::executeLifecycleOrder(LifecycleVerb /*verb*/, const std::string& /*process*/,
                                           const std::string& /*component*/) {
  Q_EMIT notice(reason_);
}

void ReplayRefusals::setLogLevel(const std::string& /*process*/, LogLevel /*level*/) {
  Q_EMIT notice(reason_);
}

// Handlers are called later, as for a running system.
void ReplayRefusals::findSchema(const std::string& /*process*/, Fingerprint type,
                                SchemaHandler handler) {
  const auto found = types_.find(type);
  const Result<Schema> reply =
      found != types_.end() ? Result<Schema>(found->second)
                            : Error{ErrorCode::kNotFound,
                                    Words::tr("this type is not in the recording").toStdString()};
  QTimer::singleShot(0, this, [handler = std::move(handler), reply] { handler(reply); });
}

void ReplayRefusals::callCommand(const std::string& /*path*/, const std::string& /*argument*/,
                                 ResultHandler handler) {
  Q_EMIT notice(reason_);
  QTimer::singleShot(0, this, [handler = std::move(handler), error = refusal()] {
    handler(Result<std::string>(error), 0.0);
  });
}

void ReplayRefusals::readValue(const std::string& /*path*/, ValueHandler handler) {
  QTimer::singleShot(0, this, [handler = std::move(handler), error = refusal()] {
    handler(Result<std::string>(error));
  });
}

void ReplayRefusals::diagnose(const message::ConnectionEnds& ends, DiagnosisHandler handler) {
  const Result<Diagnosis> diagnosis = Diagnose(store_.catalogue(), ends);
  QTimer::singleShot(0, this, [handler = std::move(handler), diagnosis] { handler(diagnosis); });
}

void ReplayRefusals::carryOut(Plan /*plan*/, AfterError /*after_error*/, Progress /*progress*/,
                              Done done) {
  PlanOutcome outcome;
  outcome.error = refusal();
  QTimer::singleShot(0, this, [done = std::move(done), outcome] { done(outcome); });
}

template <typename T>
void ReplayReports::refuse(Handler<T> handler) {
  QTimer::singleShot(0, this, [handler = std::move(handler), reason = reason_.toStdString()] {
    handler(Result<T>(Error{ErrorCode::kDenied, reason}));
  });
}

void ReplayReports::askHealth(Handler<message::SystemHealth> handler) {
  refuse(std::move(handler));
}

void ReplayReports::askCounts(const InterfaceName& /*required*/,
                              Handler<ConnectionCounts> handler) {
  refuse(std::move(handler));
}

void ReplayReports::askFill(const std::string& /*process*/, const std::string& /*component*/,
                            Handler<MailboxFill> handler) {
  refuse(std::move(handler));
}

void ReplayReports::askHistory(const std::string& /*process*/,
                               Handler<message::ProcessHistoryState> handler) {
  refuse(std::move(handler));
}

void ReplayReports::askChildren(Handler<message::Children> handler) { refuse(std::move(handler)); }

void ReplayReports::askClasses(const std::string& /*process*/, Handler<message::Classes> handler) {
  refuse(std::move(handler));
}

}  // namespace tendon::gui
