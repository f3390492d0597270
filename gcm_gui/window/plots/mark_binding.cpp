#include <gcm_gui/models/state_of.h>
#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/window/plots/mark_binding.h>

#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

std::int64_t SteadyNow() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// On the steady clock, of `when`, ns since 1970.
std::int64_t SteadyTimeOf(std::int64_t when) { return SteadyNow() - (WallClock() - when); }

QString LastPart(const QString& path) { return path.section('.', -1).section('/', -1); }

QString Name(const InterfaceName& name) { return ToQString(ToString(name)); }

}  // namespace

MarkBinding::MarkBinding(PlotPanel& panel, CatalogueStore& store, ActivityModel& activity,
                         QObject* parent)
    : QObject(parent), panel_(panel) {
  connect(&activity, &ActivityModel::finished, this, &MarkBinding::markAction);
  connect(&store, &CatalogueStore::changed, this, &MarkBinding::compare);
  Touched all;
  for (const auto& [name, entry] : store.catalogue().processes()) all.insert({name, {}});
  compare(store.catalogue(), all);
}

void MarkBinding::add(Mark::Kind kind, const QString& label, const QString& text, bool is_bad) {
  panel_.addMark(
      {.kind = kind, .time_ns = SteadyNow(), .label = label, .text = text, .is_bad = is_bad});
}

void MarkBinding::markEvent(const QString& path, const QString& value, qint64 when) {
  panel_.addMark({.kind = Mark::Kind::kEvent,
                  .time_ns = SteadyTimeOf(when),
                  .label = LastPart(path),
                  .text = (path + ' ' + value).trimmed()});
}

// What was done to connections is marked when the catalogue says so, whoever did it.
void MarkBinding::markAction(const Action& action) {
  const bool is_call = action.verb == Action::Verb::kCall;
  const bool is_refused = action.outcome == Action::Outcome::kRefused;
  if (!is_call && !is_refused) return;
  const QString object = is_call ? action.command : Name(action.required);
  QString text = (is_call ? "call " + object + ' ' + action.argument : object).trimmed();
  if (is_refused) text += ": " + action.refusal;
  panel_.addMark({.kind = is_call ? Mark::Kind::kCommand : Mark::Kind::kConnection,
                  .time_ns = SteadyTimeOf(action.when),
                  .label = LastPart(object),
                  .text = text,
                  .is_bad = is_refused});
}

void MarkBinding::compare(const Catalog& catalogue, const Touched& touched) {
  for (const TouchedPart& part : touched) {
    compareProcess(catalogue, part.process);
    compareConnections(catalogue, part);  // before the components: those not known yet are new
    const ProcessEntry* entry = catalogue.FindProcess(part.process);
    if (entry != nullptr) {
      for (const auto& [name, component] : entry->components) {
        if (part.component.empty() || part.component == name) compareComponent(*entry, component);
      }
    }
  }
}

void MarkBinding::compareProcess(const Catalog& catalogue, const std::string& process) {
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
  const QString what = IsGone(state) ? QStringLiteral(" lost") : QStringLiteral(" is back");
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
  const QString state = ToQString(ToString(component.state));
  const QString name = ToQString(component.name);
  QString text = ToQString(entry.process.name) + '/' + name + " is " + state;
  if (is_bad) text += ": " + ToQString(component.fault);
  add(Mark::Kind::kState, name + ' ' + state, text, is_bad);
}

void MarkBinding::compareConnections(const Catalog& catalogue, const TouchedPart& part) {
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
    add(Mark::Kind::kConnection, ToQString(required.component) + " disconnected",
        Name(required) + " is no longer connected to " + Name(provided) + why, now != nullptr);
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
    add(Mark::Kind::kConnection, ToQString(connection.required.component) + " connected",
        Name(connection.required) + " is connected to " + Name(connection.provided), false);
  }
}

}  // namespace tendon::gui
