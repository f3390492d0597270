#include <gcm_gui/activity/events_model.h>

#include <gcm_gui/activity/log_filter.h>
#include <gcm_gui/models/row_roles.h>
#include <gcm_gui/models/text.h>

#include <algorithm>

namespace tendon::gui {
namespace {

constexpr std::int64_t kRateWindow = 2'000'000'000;  // ns
constexpr std::size_t kMaxTimes = 100'000;

}  // namespace

int EventsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(events_.size());
}

QVariant EventsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  const EventRecord& event = eventAt(index.row());
  switch (role) {
    case Qt::DisplayRole:
      return event.path.section('.', -1);
    case kDetailRole:
      return event.value;
    case kTrailRole: {
      const QString interface = event.path.section('.', 0, -2);
      const bool is_below = !part_.isEmpty() && interface.startsWith(part_ + '/');
      return is_below ? interface.mid(part_.size() + 1) : interface;
    }
    case kTimeRole:
      return ClockText(event.when);
    case kGlyphRole:
      return QStringLiteral("⚡");
    case kFontStyleRole:
      return static_cast<int>(FontStyle::kStrong);
    case kPathRole:
      return event.path;
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
      return QString(event.path + ' ' + event.value).trimmed();
    default:
      return {};
  }
}

bool EventsModel::isOfPart(const QString& path) const {
  if (part_.isEmpty() || path == part_) return true;
  return path.startsWith(part_) && (path[part_.size()] == '/' || path[part_.size()] == '.');
}

bool EventsModel::isShown(const EventRecord& event) const {
  return words_.isEmpty() || HasWords(event.path, event.value, words_);
}

void EventsModel::setPart(const QString& path) {
  if (path == part_) return;
  part_ = path;
  startOver();
}

void EventsModel::setWords(const QStringList& words) {
  beginResetModel();
  words_ = words;
  events_.clear();
  for (const EventRecord& event : all_) {
    if (isShown(event)) events_.push_front(event);
  }
  endResetModel();
}

void EventsModel::clear() {
  beginResetModel();
  all_.clear();
  events_.clear();
  waiting_.clear();
  endResetModel();
}

void EventsModel::startOver() {
  lost_ = 0;
  times_.clear();
  clear();
}

void EventsModel::setPaused(bool paused) {
  is_paused_ = paused;
  if (!paused) show(std::exchange(waiting_, {}));
}

void EventsModel::add(const std::vector<EventRecord>& events) {
  std::vector<EventRecord> fresh;
  for (const EventRecord& event : events) {
    if (!isOfPart(event.path)) continue;
    times_.push_back(event.when);
    fresh.push_back(event);
  }
  while (times_.size() > kMaxTimes ||
         (!times_.empty() && times_.front() + kRateWindow < times_.back())) {
    times_.pop_front();
  }
  if (!is_paused_) return show(fresh);
  waiting_.insert(waiting_.end(), fresh.begin(), fresh.end());
  if (waiting_.size() > kept_) {
    waiting_.erase(waiting_.begin(), waiting_.end() - static_cast<std::ptrdiff_t>(kept_));
  }
}

void EventsModel::addLost(const QString& path, std::uint64_t count) {
  if (isOfPart(path)) lost_ += count;
}

void EventsModel::show(const std::vector<EventRecord>& fresh) {
  std::vector<EventRecord> shown;
  for (const EventRecord& event : fresh) {
    all_.push_back(event);
    if (isShown(event)) shown.push_back(event);
  }
  while (all_.size() > kept_) all_.pop_front();
  if (shown.size() > kept_) {
    shown.erase(shown.begin(), shown.end() - static_cast<std::ptrdiff_t>(kept_));
  }
  if (shown.empty()) return;
  beginInsertRows({}, 0, static_cast<int>(shown.size()) - 1);
  for (const EventRecord& event : shown) events_.push_front(event);
  endInsertRows();
  if (events_.size() <= kept_) return;
  beginRemoveRows({}, static_cast<int>(kept_), rowCount() - 1);
  events_.resize(kept_);
  endRemoveRows();
}

double EventsModel::rate(std::int64_t now) const {
  const auto first = std::lower_bound(times_.begin(), times_.end(), now - kRateWindow);
  return static_cast<double>(times_.end() - first) / (static_cast<double>(kRateWindow) * 1e-9);
}

}  // namespace tendon::gui
