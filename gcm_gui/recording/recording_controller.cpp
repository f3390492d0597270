#include <gcm_gui/recording/recording_controller.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/series/signal_path.h>
#include <gcm_gui/recording/recording_words.h>

#include <QDateTime>
#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <array>
#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kSavedPast{30};

/// In the order of RecordingScope.
constexpr std::array kScopeNames = {"plotted", "selected", "everything"};

QString DefaultFolder() {
  const QString documents = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
  const QString folder =
      documents.isEmpty()
          ? QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) + "/tendon"
          : documents;
  return folder + QStringLiteral("/recordings");
}

/// Returns `robot/arm/state.Joints` for `robot/arm/state.Joints.position[0]`, because a recording
/// contains whole columns.
QString PatternOfSignal(const QString& path) { return SourceOf(path) + '.' + ColumnOf(path); }

/// Returns `robot/arm` for an object in this component, and `robot` for the process itself.
QString PatternOfSelection(const QString& path) {
  return path.section('/', 0, 1).section('.', 0, 0);
}

/// Quotes only globs.
QString ShellWords(const QStringList& words) {
  QStringList quoted;
  for (const QString& word : words) quoted << (word.contains('*') ? ShellWord(word) : word);
  return quoted.join(' ');
}

}  // namespace

RecordingController::RecordingController(RecordingRunner& runner, ActivityModel& activity,
                                         Sources sources, QObject* parent)
    : QObject(parent),
      runner_(runner),
      activity_(activity),
      sources_(std::move(sources)),
      folder_(DefaultFolder()) {
  connect(&runner, &RecordingRunner::begun, this, Guarded(this, &RecordingController::onBegun));
  connect(&runner, &RecordingRunner::refused, this, Guarded(this, &RecordingController::onRefused));
  connect(&runner, &RecordingRunner::progressed, this,
          Guarded(this, &RecordingController::onProgressed));
  connect(&runner, &RecordingRunner::interrupted, this,
          Guarded(this, &RecordingController::onInterrupted));
  connect(&runner, &RecordingRunner::ended, this, Guarded(this, &RecordingController::onEnded));
}

void RecordingController::setScope(RecordingScope scope) {
  scope_ = scope;
  Q_EMIT changed();
}

void RecordingController::setFolder(const QString& folder) {
  if (folder.isEmpty()) return;
  folder_ = QDir::cleanPath(folder);
  Q_EMIT changed();
}

QByteArray RecordingController::choices() const {
  const char* scope = kScopeNames[static_cast<std::size_t>(scope_)];
  return QJsonDocument(QJsonObject{{"folder", folder_}, {"scope", QString::fromLatin1(scope)}})
      .toJson(QJsonDocument::Compact);
}

void RecordingController::restoreChoices(const QByteArray& choices) {
  const QJsonObject all = QJsonDocument::fromJson(choices).object();
  const QString scope = all.value(QStringLiteral("scope")).toString();
  for (std::size_t i = 0; i < kScopeNames.size(); ++i) {
    if (scope == QLatin1String(kScopeNames[i])) scope_ = static_cast<RecordingScope>(i);
  }
  setFolder(all.value(QStringLiteral("folder")).toString());
  Q_EMIT changed();
}

QStringList RecordingController::chosenPatterns() const {
  QStringList patterns;
  switch (scope_) {
    case RecordingScope::kPlotted:
      for (const QString& path : sources_.plotted()) patterns << PatternOfSignal(path);
      break;
    case RecordingScope::kSelected:
      for (const QString& path : sources_.selected()) patterns << PatternOfSelection(path);
      break;
    case RecordingScope::kEverything:
      patterns << QStringLiteral("**");
      break;
  }
  patterns.removeDuplicates();
  return patterns;
}

QString RecordingController::chosenSubject() const {
  switch (scope_) {
    case RecordingScope::kPlotted:
      return CountText(sources_.plotted().size(), Words::tr("%1 plotted signal"),
                       Words::tr("%1 plotted signals"));
    case RecordingScope::kSelected:
      return chosenPatterns().join(QStringLiteral(", "));
    case RecordingScope::kEverything:
      break;
  }
  return Words::tr("everything");
}

void RecordingController::toggle() {
  if (state_ == State::kIdle) return start();
  stop();
}

void RecordingController::start() { begin(std::chrono::seconds(0)); }

void RecordingController::saveLast() { begin(kSavedPast); }

void RecordingController::begin(std::chrono::seconds past) {
  if (state_ != State::kIdle) return;
  past_ = past;
  patterns_ = chosenPatterns();
  if (patterns_.isEmpty()) {
    return setReport({.kind = RecordingReport::Kind::kNothingChosen,
                      .title = scope_ == RecordingScope::kPlotted
                                   ? Words::tr("Nothing is plotted")
                                   : Words::tr("Nothing is selected"),
                      .detail = scope_ == RecordingScope::kPlotted
                                    ? Words::tr("Plot a signal (P), or select another subject "
                                                "in the menu Record.")
                                    : Words::tr("Select a component, or select another subject "
                                                "in the menu Record."),
                      .file = {}});
  }
  subject_ = chosenSubject();
  progress_ = {};
  interruptions_.clear();
  report_.reset();
  const QString name = QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd_HH-mm-ss"));
  file_ = folder_ + '/' + name + QStringLiteral(".mcap");
  state_ = State::kStarting;
  RecordingRequest request{.patterns = {}, .folder = folder_, .name = name, .past = past};
  for (const QString& pattern : patterns_) request.patterns.push_back(pattern.toStdString());
  runner_.start(request);
  Q_EMIT changed();
}

void RecordingController::stop() {
  if (state_ == State::kIdle || state_ == State::kStopping) return;
  state_ = State::kStopping;
  runner_.stop();
  Q_EMIT changed();
}

void RecordingController::dismissReport() {
  report_.reset();
  Q_EMIT changed();
}

void RecordingController::setReport(RecordingReport report) {
  report_ = std::move(report);
  Q_EMIT changed();
}

Action RecordingController::actionFor(const QString& file) const {
  Action action;
  const bool is_past = past_.count() > 0;
  action.verb = is_past ? Action::Verb::kSaveLast : Action::Verb::kRecord;
  action.argument = ShellWords(patterns_);
  if (is_past) action.argument.prepend(QStringLiteral("%1s ").arg(past_.count()));
  action.file = file;
  return action;
}

void RecordingController::onBegun(const QString& file) {
  file_ = file;
  action_ = activity_.begin(actionFor(file));
  if (state_ == State::kStarting) state_ = State::kRecording;
  Q_EMIT changed();
}

void RecordingController::onRefused(const QString& sentence) {
  state_ = State::kIdle;
  if (sentence.isEmpty()) return Q_EMIT changed();
  activity_.finish(activity_.begin(actionFor(file_)), 0.0, sentence);
  setReport({.kind = RecordingReport::Kind::kFailed,
             .title = past_.count() > 0 ? Words::tr("Nothing is saved")
                                        : Words::tr("Nothing is recorded"),
             .detail = sentence,
             .file = {}});
}

void RecordingController::onProgressed(const RecordingProgress& progress) {
  progress_ = progress;
  Q_EMIT changed();
}

void RecordingController::onInterrupted(const QString& sentence) {
  interruptions_ << sentence;
  Q_EMIT changed();
  Q_EMIT notice(Words::tr("The recording continues: %1").arg(sentence));
}

void RecordingController::onEnded(const RecordingProgress& progress, const QString& failure) {
  progress_ = progress;
  state_ = State::kIdle;
  activity_.finish(action_, progress.seconds, failure);
  if (!failure.isEmpty()) {
    return setReport({.kind = RecordingReport::Kind::kFailed,
                      .title = Words::tr("The recording has stopped"),
                      .detail = failure,
                      .file = file_});
  }
  if (past_.count() > 0) return reportPast();
  const auto& counts = progress.status.counts;
  const std::uint64_t lost = progress.status.losses.all();
  setReport({.kind = RecordingReport::Kind::kDone,
             .title = Words::tr("Recorded %1 rows in %2 (%3, %4 lost)")
                          .arg(counts.rows)
                          .arg(LengthText(progress.seconds), BytesText(counts.bytes))
                          .arg(lost),
             .detail = file_,
             .file = file_,
             .has_losses = lost > 0});
}

void RecordingController::reportPast() {
  const auto& counts = progress_.status.counts;
  const bool is_whole = progress_.shortfalls.isEmpty();
  setReport({.kind = RecordingReport::Kind::kDone,
             .title = Words::tr("Saved the last %1 s: %2 rows, %3 events (%4)")
                          .arg(past_.count())
                          .arg(counts.rows)
                          .arg(counts.events)
                          .arg(BytesText(counts.bytes)),
             .detail = is_whole ? file_ : progress_.shortfalls.join(QStringLiteral("; ")),
             .file = file_,
             .has_losses = !is_whole});
}

}  // namespace tendon::gui
