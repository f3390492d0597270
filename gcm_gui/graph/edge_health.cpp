#include <gcm_gui/graph/edge_health.h>
#include <gcm_gui/models/text.h>

#include <QPointer>
#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kBetween{1};
constexpr std::chrono::milliseconds kLate{100};
constexpr double kFull = 0.8;  // of a mailbox

/// By how much a counter has grown; one that is smaller has begun anew.
std::uint64_t Growth(std::uint64_t now, std::uint64_t before) {
  return now >= before ? now - before : now;
}

}  // namespace

QString HealthWarning(const ConnectionCounts& now, const std::optional<ConnectionCounts>& before) {
  QStringList warnings;
  if (before && Growth(now.refused, before->refused) > 0) {
    warnings.append(QStringLiteral("%1 calls found no room").arg(now.refused));
  }
  if (before && Growth(now.lost_events, before->lost_events) > 0) {
    warnings.append(QStringLiteral("%1 events were lost").arg(now.lost_events));
  }
  if (now.capacity > 0 &&
      static_cast<double>(now.waiting) >= kFull * static_cast<double>(now.capacity)) {
    warnings.append(QStringLiteral("%1 of %2 calls wait").arg(now.waiting).arg(now.capacity));
  }
  if (now.round_trip > kLate) {
    const double seconds = std::chrono::duration<double>(now.round_trip).count();
    warnings.append(QStringLiteral("answers after ") + DurationText(seconds));
  }
  return warnings.join(QStringLiteral("; "));
}

EdgeHealth::EdgeHealth(const CatalogueStore& store, ConnectionChecks& checks, QObject* parent)
    : QObject(parent), store_(store), checks_(checks) {
  second_.setInterval(kBetween);
  connect(&second_, &QTimer::timeout, this, &EdgeHealth::look);
}

void EdgeHealth::setLooking(bool looking) { looking ? second_.start() : second_.stop(); }

void EdgeHealth::look() {
  if (is_asking_) return;
  std::optional<InterfaceName> first;
  std::optional<InterfaceName> next;
  for (const auto& [process, entry] : store_.catalogue().processes()) {
    if (entry.process.state != ProcessState::kAlive) continue;
    for (const auto& [id, connection] : entry.connections) {
      if (connection.state != ConnectionState::kActive) continue;
      const InterfaceName& name = connection.required;
      if (!first || name < *first) first = name;
      if (last_ < name && (!next || name < *next)) next = name;
    }
  }
  if (!next) next = first;
  if (!next) return;
  is_asking_ = true;
  last_ = *next;
  checks_.findCounts(last_, [self = QPointer(this), required = last_](const auto& counts) {
    if (self != nullptr) self->hear(required, counts);
  });
}

void EdgeHealth::hear(const InterfaceName& required, const Result<ConnectionCounts>& counts) {
  is_asking_ = false;
  if (!counts) {
    known_.erase(required);
    return Q_EMIT found(required, {});
  }
  const auto it = known_.find(required);
  const auto before = it == known_.end() ? std::nullopt : std::optional(it->second);
  known_[required] = *counts;
  Q_EMIT found(required, HealthWarning(*counts, before));
}

}  // namespace tendon::gui
