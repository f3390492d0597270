#include <gcm_gui/graph/connect_mode.h>
#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/state_of.h>
#include <gcm_gui/models/text.h>

#include <QStringList>
#include <algorithm>
#include <tuple>

namespace tendon::gui {
namespace {

constexpr int kDigits = 9;

QString Name(const InterfaceName& name) { return ToQString(ToString(name)); }

/// Best first: fits, is alive, fills more, is near.
bool IsBetter(const Candidate& a, const Candidate& b, const std::string& process) {
  const auto key = [&](const Candidate& c) {
    return std::tuple(!c.fits(), c.gone, -c.compatibility.matched, c.port.name.process != process);
  };
  return std::pair(key(a), a.port) < std::pair(key(b), b.port);
}

}  // namespace

bool Candidate::looksAlike() const {
  if (compatibility.fits()) return false;
  return compatibility.matched > 0 ||
         std::any_of(compatibility.mismatches.begin(), compatibility.mismatches.end(),
                     [](const Mismatch& m) { return m.kind != Mismatch::Kind::kMissing; });
}

QStringList Candidate::reasons() const {
  QStringList reasons;
  if (!obstacle.isEmpty()) reasons.append(obstacle);
  for (const auto& mismatch : compatibility.mismatches) reasons.append(ToQString(mismatch.text));
  return reasons;
}

ConnectMode::ConnectMode(const CatalogueStore& store, SystemActions& actions, QObject* parent)
    : QObject(parent), store_(store), actions_(actions) {
  connect(&store, &CatalogueStore::changed, this, &ConnectMode::follow);
}

const Candidate* ConnectMode::best() const {
  return candidates_.empty() || !candidates_.front().fits() ? nullptr : &candidates_.front();
}

const Candidate* ConnectMode::find(const PortName& port) const {
  const auto it = std::find_if(candidates_.begin(), candidates_.end(),
                               [&](const Candidate& c) { return c.port == port; });
  return it == candidates_.end() ? nullptr : &*it;
}

const Candidate* ConnectMode::bestLookAlike() const {
  const auto it = std::find_if(candidates_.begin(), candidates_.end(),
                               [](const Candidate& c) { return !c.gone && c.looksAlike(); });
  return it == candidates_.end() ? nullptr : &*it;
}

void ConnectMode::follow() {
  if (!active()) return;
  const PortName port = *chosen_;
  const bool required = port.side == Side::kRequired;
  const bool there = required ? store_.catalogue().FindRequired(port.name) != nullptr
                              : store_.catalogue().FindProvided(port.name) != nullptr;
  if (!there || (required && store_.catalogue().FindConnection(port.name) != nullptr))
    return leave();
  rank();
  Q_EMIT changed();
}

bool ConnectMode::start(const PortName& port) {
  if (port.side == Side::kRequired) {
    if (store_.catalogue().FindRequired(port.name) == nullptr) return false;
    if (const auto* connection = store_.catalogue().FindConnection(port.name)) {
      Q_EMIT notice(Name(port.name) + QStringLiteral(" is connected to ") +
                    Name(connection->provided) + QStringLiteral(" · D disconnects"));
      return false;
    }
  } else if (store_.catalogue().FindProvided(port.name) == nullptr) {
    return false;
  }
  chosen_ = port;
  rank();
  Q_EMIT changed();
  return true;
}

void ConnectMode::leave() {
  if (!active()) return;
  chosen_.reset();
  candidates_.clear();
  Q_EMIT changed();
}

void ConnectMode::pick(const PortName& port) {
  if (!active()) return;
  const Candidate* candidate = find(port);
  if (candidate == nullptr) return;
  if (!candidate->fits()) {
    Q_EMIT notice(Name(port.name) + QStringLiteral(" does not fit: ") +
                  candidate->reasons().join(QStringLiteral("; ")));
    return;
  }
  const bool from_required = chosen_->side == Side::kRequired;
  const InterfaceName required = from_required ? chosen_->name : port.name;
  const InterfaceName provided = from_required ? port.name : chosen_->name;
  leave();
  actions_.connectInterfaces(required, provided);
  Q_EMIT picked(required, provided);
}

void ConnectMode::pickNumber(int number) {
  const auto it = std::find_if(candidates_.begin(), candidates_.end(),
                               [&](const Candidate& c) { return c.number == number; });
  if (number > 0 && it != candidates_.end()) pick(PortName(it->port));
}

void ConnectMode::pickBest() {
  if (const Candidate* candidate = best()) pick(PortName(candidate->port));
}

void ConnectMode::rank() {
  candidates_.clear();
  if (chosen_->side == Side::kRequired) {
    addProvided(*store_.catalogue().FindRequired(chosen_->name));
  } else {
    addRequired(*store_.catalogue().FindProvided(chosen_->name));
  }
  std::sort(candidates_.begin(), candidates_.end(),
            [this](const auto& a, const auto& b) { return IsBetter(a, b, chosen_->name.process); });
  int number = 0;
  for (Candidate& candidate : candidates_) {
    if (candidate.fits() && number < kDigits) candidate.number = ++number;
  }
}

void ConnectMode::addProvided(const RequiredDescription& required) {
  for (const auto& [process, entry] : store_.catalogue().processes()) {
    for (const auto& [name, component] : entry.components) {
      for (const auto& provided : component.provided) {
        candidates_.push_back({{Side::kProvided, {process, name, provided.name}},
                               Compare(required, provided),
                               0,
                               IsGone(entry.process.state),
                               {}});
      }
    }
  }
}

void ConnectMode::addRequired(const ProvidedDescription& provided) {
  const ConnectionIndex connections(store_.catalogue());
  for (const auto& [process, entry] : store_.catalogue().processes()) {
    for (const auto& [name, component] : entry.components) {
      for (const auto& required : component.required) {
        Candidate candidate{{Side::kRequired, {process, name, required.name}},
                            Compare(required, provided),
                            0,
                            IsGone(entry.process.state),
                            {}};
        if (const auto* connection = connections.Of(candidate.port.name)) {
          candidate.obstacle = QStringLiteral("is connected to ") + Name(connection->provided);
        }
        candidates_.push_back(std::move(candidate));
      }
    }
  }
}

}  // namespace tendon::gui
