#include "support/fakes.h"

#include <gcm_gui/models/text.h>
#include <tendon/base/name.h>
#include <tendon/payload/schema.h>
#include <tendon/task/cycle_statistics.h>

#include <QDesktopServices>
#include <utility>

namespace tendon::gui {
namespace {

QString Name(const InterfaceName& name) { return QString::fromStdString(ToString(name)); }

}  // namespace

void RecordingActions::connectInterfaces(const InterfaceName& required,
                                         const InterfaceName& provided) {
  asked.append(QStringLiteral("connect if free %1 %2").arg(Name(required), Name(provided)));
}

void RecordingActions::connectOrReplace(const InterfaceName& required,
                                        const InterfaceName& provided) {
  asked.append(QStringLiteral("connect %1 %2").arg(Name(required), Name(provided)));
}

void RecordingActions::disconnectInterface(const InterfaceName& required) {
  asked.append(QStringLiteral("disconnect ") + Name(required));
}

void RecordingActions::forget(const std::string& process) {
  asked.append(QStringLiteral("forget ") + QString::fromStdString(process));
}

void RecordingActions::executeLifecycleOrder(LifecycleVerb verb, const std::string& process,
                                             const std::string& component) {
  const std::string_view word = ToString(verb);
  asked.append(QString::fromStdString(std::string(word) + ' ' + process + '/' + component));
}

void RecordingActions::setLogLevel(const std::string& process, LogLevel level) {
  asked.append(QStringLiteral("log-level ") + QString::fromStdString(process) + ' ' +
               QString::fromStdString(std::string(ToString(level))));
}

void ScriptedReports::listen(const QObject* owner, const QStringList& patterns) {
  wanted_[owner] = patterns;
}

void ScriptedReports::askCounts(const InterfaceName& required, Handler<ConnectionCounts> handler) {
  counted.append(Name(required));
  if (answers_counts) return handler(counts);
  count_handlers.push_back(std::move(handler));
}

void ScriptedReports::askFill(const std::string& /*process*/, const std::string& /*component*/,
                              Handler<MailboxFill> handler) {
  handler(fill);
}

void ScriptedReports::askChildren(Handler<message::Children> handler) {
  if (children) handler(*children);
}

void ScriptedReports::askClasses(const std::string& process, Handler<message::Classes> handler) {
  asked_for_classes.append(QString::fromStdString(process));
  class_handlers.push_back(std::move(handler));
}

QStringList ScriptedReports::listened() const {
  QStringList all;
  for (const QStringList& patterns : wanted_) all += patterns;
  return all;
}

void ScriptedReports::sendLog(LogLevel level, const std::string& source, const std::string& text) {
  LogBatch batch;
  batch.records.push_back(
      {.time = WallClock(), .level = level, .process = "robot", .source = source, .text = text});
  Q_EMIT logArrived(batch);
}

void ScriptedCalls::findSchema(const std::string& /*process*/, Fingerprint type,
                               SchemaHandler handler) {
  ++asked_for_schema;
  const auto own = schemas.find(type);
  handler(own == schemas.end() ? schema : Result<Schema>(own->second));
}

void ScriptedCalls::callCommand(const std::string& path, const std::string& argument,
                                ResultHandler handler) {
  calls.append(QString::fromStdString(path + ' ' + argument).trimmed());
  answer = std::move(handler);
}

void ScriptedCalls::readValue(const std::string& path, ValueHandler handler) {
  read.append(QString::fromStdString(path));
  value = std::move(handler);
}

void ScriptedChecks::diagnose(const message::ConnectionEnds& ends, DiagnosisHandler handler) {
  diagnosed.push_back(ends);
  diagnosis = std::move(handler);
}

ScriptedFileManager::ScriptedFileManager() {
  QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "show");
}

ScriptedFileManager::~ScriptedFileManager() {
  QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
}

std::vector<std::optional<NumericValue>> ExactValues(const std::vector<double>& values) {
  std::vector<std::optional<NumericValue>> exact;
  for (const double value : values) exact.emplace_back(NumericValue(value));
  return exact;
}

void ScriptedSignals::watch(const QObject* owner, const QSet<QString>& columns) {
  watched_[owner] = columns;
}

QSet<QString> ScriptedSignals::watched() const {
  QSet<QString> all;
  for (const auto& columns : watched_) all.unite(columns);
  return all;
}

void ScriptedSignals::send(const QString& column, const Schema& schema,
                           const std::vector<double>& values) {
  NumericFieldList& shape = shapes_[column];
  if (shape == nullptr)
    shape = std::make_shared<const std::vector<NumericField>>(NumericFields(schema));
  Q_EMIT valuesArrived(column, ColumnValues{shape, ExactValues(values), {}});
}

void ScriptedSignals::sendPicture(const QString& column, const RawImage& picture) {
  NumericFieldList& shape = shapes_[column];
  if (shape == nullptr) shape = std::make_shared<const std::vector<NumericField>>();
  Q_EMIT valuesArrived(column, {shape, {}, {}, std::make_shared<const RawImage>(picture)});
}

Schema CycleSchema() {
  const Schema number(Schema::Kind::kFloat64);
  return Schema::Structure("tendon.CycleStatistics",
                           {{"period", "s", number},
                            {"lateness", "s", number},
                            {"compute", "s", number},
                            {"overruns", "", Schema(Schema::Kind::kUint64)}});
}

void SendSummary(ScriptedSignals& source, const QString& component, const SummaryValues& values) {
  std::vector<double> row{values.cycles};
  // mean, deviation, min, max, p50, p99 of each
  row.insert(row.end(), {values.period, 0, 0, 0, 0, 0});
  row.insert(row.end(), {0, 0, 0, values.latest, values.late, values.later});
  row.insert(row.end(), {values.compute, 0, 0, 0, 0, 0});
  source.send(component + QStringLiteral("/state.CycleSummary"), SchemaOf<CycleSummary>(), row);
}

}  // namespace tendon::gui
