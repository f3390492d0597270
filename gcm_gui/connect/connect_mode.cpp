#include <gcm_gui/connect/connect_mode.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/connection_index.h>
#include <gcm_gui/models/state_marks.h>
#include <gcm_gui/models/text.h>

#include <algorithm>
#include <tuple>

namespace tendon::gui {
namespace {

constexpr int kDigits = 9;

/// Returns true if `a` is the better candidate. In order of importance, a better candidate fits, is
/// alive, is free, matches more members, and is in the same process.
bool IsBetter(const PortCandidate& a, const PortCandidate& b, const std::string& process) {
  const auto key = [&](const PortCandidate& c) {
    return std::tuple(!c.fits(), c.gone, c.former.has_value(), -c.compatibility.matched,
                      c.port.name.process != process);
  };
  const auto key_of_a = key(a);
  const auto key_of_b = key(b);
  return key_of_a != key_of_b ? key_of_a < key_of_b : a.port < b.port;
}

}  // namespace

bool PortCandidate::looksAlike() const {
  if (compatibility.fits()) return false;
  return compatibility.matched > 0 ||
         std::any_of(compatibility.mismatches.begin(), compatibility.mismatches.end(),
                     [](const Mismatch& m) { return m.kind != Mismatch::Kind::kMissing; });
}

QStringList PortCandidate::reasons() const {
  QStringList reasons;
  if (present) reasons.append(Words::tr("is the current connection"));
  for (const auto& mismatch : compatibility.mismatches) reasons.append(ToQString(mismatch.text));
  return reasons;
}

ConnectMode::ConnectMode(const CatalogueStore& store, SystemActions& actions, QObject* parent)
    : QObject(parent), store_(store), actions_(actions) {
  connect(&store, &CatalogueStore::changed, this, Guarded(this, &ConnectMode::follow));
  connect(&store, &CatalogueStore::typesLearned, this, Guarded(this, &ConnectMode::follow));
}

const PortCandidate* ConnectMode::best() const {
  return candidates_.empty() || !candidates_.front().fits() ? nullptr : &candidates_.front();
}

const PortCandidate* ConnectMode::find(const PortName& port) const {
  const auto it = places_.find(port);
  return it == places_.end() ? nullptr : &candidates_[it->second];
}

const PortCandidate* ConnectMode::bestLookAlike() const {
  const auto it = std::find_if(candidates_.begin(), candidates_.end(),
                               [](const PortCandidate& c) { return !c.gone && c.looksAlike(); });
  return it == candidates_.end() ? nullptr : &*it;
}

bool ConnectMode::isThere(const PortName& port) const {
  return port.side == Side::kRequired ? store_.catalogue().FindRequired(port.name) != nullptr
                                      : store_.catalogue().FindProvided(port.name) != nullptr;
}

std::optional<InterfaceName> ConnectMode::peerOf(const PortName& port) const {
  if (port.side == Side::kProvided) return std::nullopt;
  const auto* connection = store_.catalogue().FindConnection(port.name);
  return connection == nullptr ? std::nullopt : std::optional(connection->provided);
}

void ConnectMode::follow() {
  if (!active()) return;
  if (!isThere(*chosen_) || peerOf(*chosen_) != former_) return leave();
  rank();
  Q_EMIT changed();
}

bool ConnectMode::start(const PortName& port) {
  if (!isThere(port)) return false;
  if (!forbidden_.isEmpty()) {
    Q_EMIT notice(forbidden_);
    return false;
  }
  chosen_ = port;
  former_ = peerOf(port);
  rank();
  Q_EMIT changed();
  return true;
}

void ConnectMode::leave() {
  if (!active()) return;
  chosen_.reset();
  former_.reset();
  candidates_.clear();
  places_.clear();
  Q_EMIT changed();
}

void ConnectMode::pick(const PortName& port) {
  if (!active()) return;
  const PortCandidate* candidate = find(port);
  if (candidate == nullptr) return;
  if (!candidate->fits()) return refuse(*candidate);
  const auto [required, provided] = endsTo(port);
  leave();
  actions_.connectOrReplace(required, provided);
  Q_EMIT picked(required, provided);
}

void ConnectMode::refuse(const PortCandidate& candidate) {
  const QString obstacle = candidate.present ? QStringLiteral(" ") : Words::tr(" does not fit: ");
  const QString reason =
      ToQString(candidate.port.name) + obstacle + candidate.reasons().join(QStringLiteral("; "));
  const message::ConnectionEnds ends = endsTo(candidate.port);
  const bool is_meant = !candidate.present && candidate.looksAlike();
  Q_EMIT notice(reason);
  if (is_meant) Q_EMIT mismatchPicked(ends, reason);
}

message::ConnectionEnds ConnectMode::endsTo(const PortName& port) const {
  const bool from_required = chosen_->side == Side::kRequired;
  return from_required ? message::ConnectionEnds{chosen_->name, port.name}
                       : message::ConnectionEnds{port.name, chosen_->name};
}

void ConnectMode::pickNumber(int number) {
  const auto it = std::find_if(candidates_.begin(), candidates_.end(),
                               [&](const PortCandidate& c) { return c.number == number; });
  if (number > 0 && it != candidates_.end()) pick(PortName(it->port));
}

void ConnectMode::pickBest() {
  if (const PortCandidate* candidate = best()) pick(PortName(candidate->port));
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
  places_.clear();
  int number = 0;
  for (std::size_t place = 0; place < candidates_.size(); ++place) {
    PortCandidate& candidate = candidates_[place];
    if (candidate.fits() && number < kDigits) candidate.number = ++number;
    places_[candidate.port] = place;
  }
}

template <typename Ports, typename Describe>
void ConnectMode::addCandidates(Side side, Ports ComponentDescription::*ports, Describe describe) {
  for (const auto& [process, entry] : store_.catalogue().processes()) {
    for (const auto& [name, component] : entry.components) {
      for (const auto& port : component.*ports) {
        PortCandidate candidate;
        candidate.port = {side, {process, name, port.name}};
        candidate.gone = IsGone(entry.process.state);
        describe(port, candidate);
        candidates_.push_back(std::move(candidate));
      }
    }
  }
}

void ConnectMode::addProvided(const RequiredDescription& required) {
  addCandidates(Side::kProvided, &ComponentDescription::provided,
                [&](const ProvidedDescription& provided, PortCandidate& candidate) {
                  candidate.compatibility = Compare(required, provided);
                  candidate.present = candidate.port.name == former_;
                });
}

void ConnectMode::addRequired(const ProvidedDescription& provided) {
  const ConnectionIndex connections(store_.catalogue());
  addCandidates(Side::kRequired, &ComponentDescription::required,
                [&](const RequiredDescription& required, PortCandidate& candidate) {
                  candidate.compatibility = Compare(required, provided);
                  const auto* connection = connections.Of(candidate.port.name);
                  if (connection == nullptr) return;
                  candidate.present = connection->provided == chosen_->name;
                  if (!candidate.present) candidate.former = connection->provided;
                });
}

}  // namespace tendon::gui
