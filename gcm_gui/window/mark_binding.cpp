#include <gcm_gui/window/mark_binding.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/series/shown_time.h>
#include <gcm_gui/window/audit_line.h>
#include <tendon/base/path.h>
#include <tendon/gcm/lookup.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

// The maximum delay of a record from its process to this window, in ns.
constexpr std::int64_t kLatestLog = 2'000'000'000;
constexpr int kOwnCalls = 32;  // the number of newest actions that are checked

/// Converts `when`, ns since 1970, to the steady clock.
std::int64_t SteadyTimeOf(std::int64_t when) { return ShownTime() - (WallClock() - when); }

/// Returns the component of a signal or event: "robot/arm".
QString ComponentPathOf(const QString& path) { return path.section('/', 0, 1); }

QString LastPart(const QString& path) { return path.section('.', -1).section('/', -1); }

}  // namespace

MarkBinding::MarkBinding(PlotPanel& panel, CatalogueStore& store, ActivityModel& activity,
                         SystemReports& reports, QObject* parent)
    : QObject(parent), panel_(panel), store_(store), activity_(activity), reports_(reports) {
  connect(&panel, &PlotPanel::subscriptionWanted, this, &MarkBinding::follow);
  connect(&panel, &PlotPanel::subscriptionReleased, this, &MarkBinding::follow);
  connect(&panel, &PlotPanel::marksShownChanged, this, &MarkBinding::follow);
  connect(&reports, &SystemReports::beganAgain, this, Guarded(this, &MarkBinding::startOver));
  connect(&reports, &SystemReports::logArrived, this, Guarded(this, &MarkBinding::markLog));
  connect(&reports, &SystemReports::eventsArrived, this,
          [this](const std::vector<EventRecord>& events) {
            ExceptionGuard::run(this, ViewWork::kHandling, [&] {
              for (const EventRecord& event : events) markEvent(event);
            });
          });
  connect(&activity, &ActivityModel::finished, this, Guarded(this, &MarkBinding::markAction));
  connect(&store, &CatalogueStore::changed, this, Guarded(this, &MarkBinding::compare));
  compareAll();
}

void MarkBinding::add(Mark::Kind kind, const QString& label, const QString& text, bool is_bad) {
  panel_.addMark(
      {.kind = kind, .time_ns = ShownTime(), .label = label, .text = text, .is_bad = is_bad});
}

void MarkBinding::follow() {
  components_plotted_.clear();
  for (const QString& path : panel_.paths()) {
    const QString component = ComponentPathOf(path);
    if (!components_plotted_.contains(component)) components_plotted_ << component;
  }
  QStringList patterns;
  if (panel_.areMarksShown()) {
    for (const QString& component : components_plotted_.mid(0, kMaxListenedTo)) {
      patterns << component + QStringLiteral("/*");
    }
  }
  reports_.listen(this, patterns);
  if (patterns.isEmpty()) events_.clear();
  if (!patterns.isEmpty() && !std::exchange(watches_log_, true)) reports_.watchLog();
}

void MarkBinding::startOver() {
  panel_.removeMarks();
  events_.clear();
  processes_.clear();
  components_.clear();
  connections_.clear();
  compareAll();
}

/// Does not mark changes of objects that were unknown before.
void MarkBinding::compareAll() {
  ChangedParts all;
  for (const auto& [name, entry] : store_.catalogue().processes()) all.insert({name, {}});
  compare(store_.catalogue(), all);
}

// This window also receives the events that only other receivers have subscribed to.
void MarkBinding::markEvent(const EventRecord& event) {
  if (!components_plotted_.contains(ComponentPathOf(event.path))) return;
  MarkedEvents& marked = events_[event.path];
  if (event.when - marked.when < kEventPauseNs && event.when >= marked.when) {
    ++marked.unmarked;
    return;
  }
  QString text = (event.path + ' ' + event.value).trimmed();
  if (marked.unmarked > 0) {
    text += Words::tr(", and %1 more since the previous mark").arg(marked.unmarked);
  }
  marked = {.when = event.when};
  panel_.addMark({.kind = Mark::Kind::kEvent,
                  .time_ns = SteadyTimeOf(event.when),
                  .label = LastPart(event.path),
                  .text = text});
}

// Marks the commands of other programs. The process that receives a command reports it in its audit
// log. Records from before the first subscription to the log are ignored.
void MarkBinding::markLog(const LogBatch& batch) {
  const bool is_new = std::exchange(log_is_current_, log_is_current_ || batch.is_current);
  if (!is_new) return;
  for (const message::LogRecord& record : batch.records) {
    const auto sent = SentCommandOf(record);
    if (!sent || isRead(sent->path) || isOwnCall(sent->path)) continue;
    const std::int64_t now = WallClock();
    // Uses the time of a record only if it is less than kLatestLog old and not in the future,
    // because the clock of another host may be wrong. In a recording, every time is accepted,
    // because a jump delivers records of any age.
    const bool is_near = IsMomentShown() || (record.time <= now && now - record.time < kLatestLog);
    panel_.addMark({.kind = Mark::Kind::kCommand,
                    .time_ns = SteadyTimeOf(is_near ? record.time : now),
                    .label = LastPart(sent->path),
                    .text = Words::tr("call ") + sent->path + Words::tr(" by ") + sent->who +
                            (sent->is_refused ? Words::tr(": refused") : ""),
                    .is_bad = sent->is_refused});
  }
}

// Reads are not marked: they change nothing, and many are automatic. For example, a form requests
// initial values, and a script requests the position of the arm.
bool MarkBinding::isRead(const QString& path) const {
  const auto parsed = ParsePath(path.toStdString());
  if (!parsed) return false;
  const auto command = LookUpCommand(store_.catalogue(), *parsed);
  if (!command) return false;
  const CommandKind kind = command->signature.kind;
  return kind == CommandKind::kRead || kind == CommandKind::kQualifiedRead;
}

// A call of this window is marked when its reply arrives. The call is in the activity list before
// it is sent, so this function finds it there.
bool MarkBinding::isOwnCall(const QString& path) const {
  const int newest = std::min(activity_.rowCount(), kOwnCalls);
  for (int row = 0; row < newest; ++row) {
    const Action& action = activity_.action(row);
    if (action.verb != Action::Verb::kCall || action.command != path) continue;
    const auto took = static_cast<std::int64_t>(action.seconds * 1e9);
    const bool is_running = action.outcome == Action::Outcome::kRunning;
    if (is_running || WallClock() - (action.when + took) < kLatestLog) return true;
  }
  return false;
}

// Does not mark changes of connections and components. compare() marks these changes from the
// catalogue, regardless of who made them.
void MarkBinding::markAction(const Action& action) {
  const bool is_call = action.verb == Action::Verb::kCall;
  const bool is_refused = action.outcome == Action::Outcome::kRefused;
  const bool is_wiring = !action.required.interface.empty();
  if (!is_call && !(is_wiring && is_refused)) return;
  const QString object = is_call ? action.command : ToQString(action.required);
  QString text = (is_call ? Words::tr("call ") + object + ' ' + action.argument : object).trimmed();
  if (is_refused) text += ": " + action.refusal;
  panel_.addMark({.kind = is_call ? Mark::Kind::kCommand : Mark::Kind::kConnection,
                  .time_ns = SteadyTimeOf(action.when),
                  .label = LastPart(object),
                  .text = text,
                  .is_bad = is_refused});
}

void MarkBinding::compare(const Catalogue& catalogue, const ChangedParts& touched) {
  for (const ChangedPart& part : touched) {
    compareProcess(catalogue, part.process);
    // Compares the connections first: connections of an unknown component are not marked, and
    // compareComponent() makes the component known.
    compareConnections(catalogue, part);
    const ProcessEntry* entry = catalogue.FindProcess(part.process);
    if (entry != nullptr) {
      for (const auto& [name, component] : entry->components) {
        if (part.component.empty() || part.component == name) compareComponent(*entry, component);
      }
    }
  }
}

void MarkBinding::compareProcess(const Catalogue& catalogue, const std::string& process) {
  const ProcessEntry* entry = catalogue.FindProcess(process);
  if (entry == nullptr) {
    processes_.erase(process);
    return;
  }
  const ProcessState state = entry->process.state;
  const auto [known, is_new] = processes_.try_emplace(process, state);
  const ProcessState former = std::exchange(known->second, state);
  if (is_new || IsGone(former) == IsGone(state)) return;
  const QString name = ToQString(process);
  const QString what = IsGone(state) ? Words::tr(" lost") : Words::tr(" is back");
  add(Mark::Kind::kState, name + what,
      (name + what + ' ' + ToQString(IsGone(state) ? entry->process.reason : "")).trimmed(),
      IsGone(state));
}

void MarkBinding::compareComponent(const ProcessEntry& entry,
                                   const ComponentDescription& component) {
  if (IsGone(entry.process.state)) return;
  const auto [known, is_new] =
      components_.try_emplace({entry.process.name, component.name}, component.state);
  const ComponentState former = std::exchange(known->second, component.state);
  if (is_new || former == component.state) return;
  const bool is_bad = component.state == ComponentState::kFaulted;
  const QString state = WordOf(MarkOf(component.state));
  const QString name = ToQString(component.name);
  QString text = Words::tr("%1 is %2").arg(ToQString(entry.process.name) + '/' + name, state);
  if (is_bad) text += ": " + ToQString(component.fault);
  add(Mark::Kind::kState, name + ' ' + state, text, is_bad);
}

void MarkBinding::compareConnections(const Catalogue& catalogue, const ChangedPart& part) {
  const auto is_meant = [&](const InterfaceName& required) {
    return required.process == part.process &&
           (part.component.empty() || required.component == part.component);
  };
  std::erase_if(connections_, [&](const auto& known) {
    const auto& [required, provided] = known;
    if (!is_meant(required)) return false;
    const ConnectionDescription* now = catalogue.FindConnection(required);
    const bool stands = now != nullptr && now->state == ConnectionState::kActive;
    if (stands) return false;
    const QString why = now != nullptr ? ' ' + ToQString(now->reason) : QString();
    add(Mark::Kind::kConnection, ToQString(required.component) + Words::tr(" disconnected"),
        ToQString(required) + Words::tr(" is no longer connected to ") + ToQString(provided) + why,
        now != nullptr);
    return true;
  });
  const ProcessEntry* entry = catalogue.FindProcess(part.process);
  if (entry == nullptr) return;
  for (const auto& [id, connection] : entry->connections) {
    if (!is_meant(connection.required) || connection.state != ConnectionState::kActive) continue;
    const auto known = connections_.find(connection.required);
    if (known != connections_.end() && known->second == connection.provided) continue;
    connections_[connection.required] = connection.provided;
    if (!components_.contains({part.process, connection.required.component})) continue;
    add(Mark::Kind::kConnection, ToQString(connection.required.component) + Words::tr(" connected"),
        ToQString(connection.required) + Words::tr(" is connected to ") +
            ToQString(connection.provided),
        false);
  }
}

}  // namespace tendon::gui
