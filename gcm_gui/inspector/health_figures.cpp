#include <gcm_gui/inspector/health_figures.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>
#include <tendon/gcm/text.h>

#include <QPointer>
#include <chrono>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kAskPeriod{1};

double InSeconds(std::chrono::nanoseconds time) {
  return std::chrono::duration<double>(time).count();
}

InterfaceHealth InterfaceHealthOf(const ConnectionCounts& counts) {
  InterfaceHealth health;
  if (counts.round_trip.count() >= 0) health.brief = DurationText(InSeconds(counts.round_trip));
  const std::uint64_t lost = counts.refused + counts.lost_events;
  if (lost > 0) health.brief = Words::tr("%1 lost").arg(lost);
  health.whole = CountsLines(counts).join(QStringLiteral("\n"));
  return health;
}

}  // namespace

HealthFigures::HealthFigures(SystemReports& reports, const CatalogueStore& store, QObject* parent)
    : QObject(parent), reports_(reports), store_(store) {
  timer_.setInterval(kAskPeriod);
  connect(&timer_, &QTimer::timeout, this, Guarded(this, &HealthFigures::ask));
}

void HealthFigures::show(const std::string& process, const std::string& component) {
  if (process == process_ && component == component_) return;
  process_ = process;
  component_ = component;
  ++shown_;
  interfaces_.clear();
  history_.reset();
  if (process_.empty()) return timer_.stop();
  timer_.start();
  ask();
}

QList<Property> HealthFigures::processFacts() const {
  const ProcessEntry* entry = store_.catalogue().FindProcess(process_);
  const auto* health = entry == nullptr ? nullptr : FindHealth(health_, entry->process);
  if (health == nullptr) return {};
  QList<Property> facts{
      {Words::tr("Processor"), ToQString(CpuText(health)),
       Words::tr("Share of one core in the last second")},
      {Words::tr("Memory"), ToQString(MemoryText(health)), Words::tr("Resident")},
      {Words::tr("Clock"),
       ToQString(tendon::ClockText(health)).replace(QStringLiteral("+-"), QStringLiteral("±")),
       Words::tr("Difference from the clock of the GCM, with its uncertainty; above 0 if the "
                 "clock of the process is ahead")}};
  if (history_) {
    facts.append({Words::tr("History"), ToQString(HistoryText(*history_)),
                  Words::tr("Rows, events and log of the last seconds, which can be saved at any "
                            "time: Record, Save the last 30 s")});
  }
  return facts;
}

void HealthFigures::ask() {
  const ProcessEntry* entry = store_.catalogue().FindProcess(process_);
  if (entry == nullptr || IsGone(entry->process.state)) return;
  reports_.askHealth([self = QPointer(this)](const Result<message::SystemHealth>& health) {
    if (self == nullptr || !health) return;
    self->health_ = *health;
    Q_EMIT self->changed();
  });
  askHistory();
  const auto component = entry->components.find(component_);
  if (component != entry->components.end()) askConnections(component->second);
}

void HealthFigures::askHistory() {
  reports_.askHistory(process_, [self = QPointer(this), shown = shown_](
                                    const Result<message::ProcessHistoryState>& history) {
    if (self == nullptr || self->shown_ != shown || !history) return;
    self->history_ = *history;
    Q_EMIT self->changed();
  });
}

void HealthFigures::askConnections(const ComponentDescription& component) {
  for (const auto& one : component.required) {
    const InterfaceName required{process_, component_, one.name};
    const auto* connection = store_.catalogue().FindConnection(required);
    if (connection == nullptr || connection->state != ConnectionState::kActive) {
      interfaces_.remove(ToQString(ToString(required)));
      continue;
    }
    reports_.askCounts(required, [self = QPointer(this), shown = shown_,
                                  required](const Result<ConnectionCounts>& counts) {
      if (self != nullptr && self->shown_ == shown) self->onCounts(required, counts);
    });
  }
  if (component.provided.empty()) return;
  reports_.askFill(process_, component_,
                   [self = QPointer(this), shown = shown_](const Result<MailboxFill>& fill) {
                     if (self != nullptr && self->shown_ == shown) self->onFill(fill);
                   });
}

void HealthFigures::onCounts(const InterfaceName& required,
                             const Result<ConnectionCounts>& counts) {
  const QString path = ToQString(ToString(required));
  if (counts) {
    interfaces_[path] = InterfaceHealthOf(*counts);
  } else {
    interfaces_.remove(path);
  }
  Q_EMIT changed();
}

void HealthFigures::onFill(const Result<MailboxFill>& fill) {
  const auto* component = store_.catalogue().FindComponent(process_, component_);
  if (component == nullptr) return;
  for (const auto& one : component->provided) {
    const QString path = ToQString(ToString(InterfaceName{process_, component_, one.name}));
    if (!fill || fill->capacity == 0) {
      interfaces_.remove(path);
      continue;
    }
    const bool is_filling = 2 * fill->waiting >= fill->capacity;
    interfaces_[path] = {
        is_filling ? Words::tr("%1 of %2").arg(fill->waiting).arg(fill->capacity) : QString(),
        Words::tr("The fullest mailbox of the component holds %1 of at most %2 messages")
            .arg(fill->waiting)
            .arg(fill->capacity)};
  }
  Q_EMIT changed();
}

}  // namespace tendon::gui
