#include <gcm_gui/session/column_signals.h>

#include <gcm_gui/models/text.h>
#include <tendon/base/path.h>

#include <optional>
#include <utility>
#include <vector>

namespace tendon::gui {

QString ColumnPathOf(const QString& signal) {
  auto path = ParsePath(signal.toStdString());
  if (!path.ok() || path->member.empty()) return {};
  path->field.clear();
  return ToQString(ToString(*path));
}

ColumnSignals::Column* ColumnSignals::open(const QString& path) {
  if (const auto it = columns_.find(path); it != columns_.end()) return &it->second;
  const auto feed = std::make_shared<ColumnFeed>();
  if (path.isEmpty() || !begin(path, feed)) return nullptr;
  Column& column = columns_[path];
  column.feed = feed;
  return &column;
}

void ColumnSignals::subscribe(const QString& signal) {
  const QString path = ColumnPathOf(signal);
  Column* column = open(path);
  if (column == nullptr) return;
  User& user = column->users[signal];
  if (++user.count > 1) return;
  user.field = signal.mid(path.size()).toStdString();
  column->feed->tap(user.field);
  onSubscribed();
}

void ColumnSignals::release(const QString& signal) {
  const auto it = columns_.find(ColumnPathOf(signal));
  if (it == columns_.end()) return;
  const auto user = it->second.users.find(signal);
  if (user == it->second.users.end() || --user->second.count > 0) return;
  it->second.feed->untap(user->second.field);
  it->second.users.erase(user);
}

void ColumnSignals::watch(const QObject* owner, const QSet<QString>& columns) {
  if (!known_owners_.contains(owner)) {
    known_owners_.insert(owner);
    connect(owner, &QObject::destroyed, this, [this, owner] {
      watch(owner, {});
      known_owners_.remove(owner);
    });
  }
  for (auto& [path, column] : columns_) {
    if (!columns.contains(path)) column.watchers.remove(owner);
  }
  for (const QString& path : columns) {
    Column* column = open(path);
    if (column == nullptr) continue;
    column->watchers.insert(owner);
    onWatched(path);
  }
}

RowLosses ColumnSignals::losses(const QString& signal) const {
  const auto it = columns_.find(ColumnPathOf(signal));
  return it == columns_.end() ? RowLosses{} : it->second.feed->losses();
}

void ColumnSignals::deliverRows() {
  // Takes all data first, because a receiver may call subscribe() or release() in its handler.
  std::vector<std::pair<QString, ColumnFeed::NewSamples>> arrived;
  for (const auto& [path, column] : columns_) {
    for (const auto& [signal, user] : column.users) {
      arrived.emplace_back(signal, column.feed->take(user.field));
    }
  }
  for (const auto& [signal, taken] : arrived) {
    if (taken.names) Q_EMIT namesLearned(signal, *taken.names);
    for (const auto& run : taken.runs) {
      if (run.begins_epoch) Q_EMIT epochBegan(signal);
      if (!run.samples.empty()) Q_EMIT samplesArrived(signal, run.samples);
    }
    if (taken.stale) Q_EMIT wentStale(signal, *taken.stale);
  }
}

void ColumnSignals::deliverNewest() {
  std::vector<std::pair<QString, ColumnValues>> arrived;
  std::vector<std::pair<QString, QString>> refused;
  for (const auto& [path, column] : columns_) {
    if (column.watchers.isEmpty()) continue;
    if (auto newest = column.feed->takeValues()) arrived.emplace_back(path, *std::move(newest));
    if (const QString why = column.feed->refusal(); !why.isEmpty()) refused.emplace_back(path, why);
  }
  for (const auto& [path, newest] : arrived) Q_EMIT valuesArrived(path, newest);
  for (const auto& [path, why] : refused) Q_EMIT valuesRefused(path, why);
}

}  // namespace tendon::gui
