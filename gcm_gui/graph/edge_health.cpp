#include <gcm_gui/graph/edge_health.h>

#include <gcm_gui/guard/exception_guard.h>
#include <gcm_gui/language/words.h>
#include <gcm_gui/models/text.h>
#include <tendon/base/path.h>
#include <tendon/gcm/connection_health.h>

#include <QPointer>
#include <algorithm>
#include <chrono>
#include <utility>

namespace tendon::gui {
namespace {

constexpr std::chrono::seconds kBetween{1};

QString FlawSentence(const ConnectionFlaw& flaw) {
  switch (flaw.kind) {
    case ConnectionFlaw::Kind::kCallsRefused:
      return (flaw.count == 1 ? Words::tr("%1 call was refused, because the mailbox was full")
                              : Words::tr("%1 calls were refused, because the mailbox was full"))
          .arg(flaw.count);
    case ConnectionFlaw::Kind::kEventsLost:
      return (flaw.count == 1 ? Words::tr("%1 event was lost") : Words::tr("%1 events were lost"))
          .arg(flaw.count);
    case ConnectionFlaw::Kind::kMailboxFull:
      return Words::tr("%1 of %2 calls wait").arg(flaw.count).arg(flaw.capacity);
    case ConnectionFlaw::Kind::kLate:
      break;
  }
  const double seconds = std::chrono::duration<double>(flaw.round_trip).count();
  return Words::tr("answers after ") + DurationText(seconds);
}

}  // namespace

QString HealthWarning(const ConnectionCounts& now, const std::optional<ConnectionCounts>& before) {
  QStringList warnings;
  for (const ConnectionFlaw& flaw : FlawsOf(now, before)) warnings.append(FlawSentence(flaw));
  return warnings.join(QStringLiteral("; "));
}

EdgeHealth::EdgeHealth(SystemReports& reports, Seen seen, QObject* parent)
    : QObject(parent), reports_(reports), seen_(std::move(seen)) {
  second_.setInterval(kBetween);
  connect(&second_, &QTimer::timeout, this, Guarded(this, &EdgeHealth::look));
}

void EdgeHealth::setLooking(bool looking) { looking ? second_.start() : second_.stop(); }

void EdgeHealth::look() {
  if (pointed_) ask(*pointed_);
  std::vector<InterfaceName> seen = seen_();
  std::sort(seen.begin(), seen.end());
  std::erase_if(known_, [&](const auto& one) {
    return one.first != pointed_ && !std::binary_search(seen.begin(), seen.end(), one.first);
  });
  const auto next = std::upper_bound(seen.begin(), seen.end(), last_);
  std::rotate(seen.begin(), next, seen.end());
  seen.resize(std::min(seen.size(), kMaxAtOnce));
  for (const InterfaceName& required : seen) {
    if (asked_.size() >= kMaxAtOnce) return;
    last_ = required;
    ask(required);
  }
}

void EdgeHealth::point(const QString& required) {
  pointed_.reset();
  const auto name = ParseInterfaceName(required.toStdString());
  if (!name.ok()) return;
  pointed_ = *name;
  const auto known = known_.find(*name);
  if (known != known_.end()) Q_EMIT counted(*name, CountsLines(known->second));
  ask(*name);
}

void EdgeHealth::ask(const InterfaceName& required) {
  if (!asked_.insert(required).second) return;
  reports_.askCounts(required, [self = QPointer(this), required](const auto& counts) {
    if (self != nullptr) self->onCounts(required, counts);
  });
}

void EdgeHealth::onCounts(const InterfaceName& required, const Result<ConnectionCounts>& counts) {
  asked_.erase(required);
  const bool is_pointed = pointed_ == required;
  if (!counts) {
    known_.erase(required);
    Q_EMIT found(required, {});
    if (is_pointed) Q_EMIT counted(required, {ToQString(counts.error().message)});
    return;
  }
  const auto it = known_.find(required);
  const auto before = it == known_.end() ? std::nullopt : std::optional(it->second);
  known_[required] = *counts;
  const QString warning = HealthWarning(*counts, before);
  Q_EMIT found(required, warning);
  if (!is_pointed) return;
  const QStringList lines = CountsLines(*counts);
  Q_EMIT counted(required, warning.isEmpty() ? lines : QStringList(warning) + lines);
}

}  // namespace tendon::gui
