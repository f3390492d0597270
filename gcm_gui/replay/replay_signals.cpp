#include <gcm_gui/replay/replay_signals.h>
#include <gcm_gui/session/live_signals.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

// Samples of all numbers together. Enough for one number for an hour at 1 kHz, which is the longest
// past that a plot gets at once.
constexpr std::size_t kMostWaiting = std::size_t{1} << 22;

}  // namespace

ReplaySignals::Column* ReplaySignals::open(const QString& path) {
  if (const auto it = columns_.find(path); it != columns_.end()) return &it->second;
  if (path.isEmpty()) return nullptr;
  Column& column = columns_[path];
  column.feed = std::make_shared<ColumnFeed>();
  Q_EMIT columnWanted(path.toStdString(), column.feed);
  return &column;
}

void ReplaySignals::subscribe(const QString& signal) {
  const QString path = ColumnPathOf(signal);
  Column* column = open(path);
  if (column == nullptr) return;
  auto& [count, field] = column->users[signal];
  if (++count > 1) return;
  field = signal.mid(path.size()).toStdString();
  Q_EMIT pastWanted();
}

void ReplaySignals::release(const QString& signal) {
  const auto it = columns_.find(ColumnPathOf(signal));
  if (it == columns_.end()) return;
  const auto user = it->second.users.find(signal);
  if (user == it->second.users.end() || --user->second.first > 0) return;
  it->second.feed->untap(user->second.second);
  it->second.users.erase(user);
}

void ReplaySignals::watch(const QObject* owner, const QSet<QString>& columns) {
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
    if (Column* column = open(path)) column->watchers.insert(owner);
  }
}

RowLosses ReplaySignals::losses(const QString& signal) const {
  const auto it = columns_.find(ColumnPathOf(signal));
  return it == columns_.end() ? RowLosses{} : it->second.feed->losses();
}

WantedColumns ReplaySignals::beginJump() {
  std::erase_if(columns_, [](const auto& entry) {
    return entry.second.users.empty() && entry.second.watchers.isEmpty();
  });
  std::size_t taps = 0;
  for (const auto& [path, column] : columns_) taps += column.users.size();
  const std::size_t most = kMostWaiting / std::max<std::size_t>(taps, 1);
  WantedColumns wanted;
  for (auto& [path, column] : columns_) {
    column.next = std::make_shared<ColumnFeed>(most);
    for (const auto& [signal, user] : column.users) column.next->tap(user.second);
    wanted[path.toStdString()] = {column.next, !column.users.empty()};
  }
  return wanted;
}

void ReplaySignals::endJump() {
  for (auto& [path, column] : columns_) {
    if (column.next != nullptr) column.feed = std::exchange(column.next, nullptr);
  }
  Q_EMIT beganAgain();
}

void ReplaySignals::deliver() {
  // Takes all data first, because a receiver may call subscribe() or release() in its handler.
  std::vector<std::pair<QString, ColumnFeed::NewSamples>> rows;
  for (const auto& [path, column] : columns_) {
    for (const auto& [signal, user] : column.users) {
      rows.emplace_back(signal, column.feed->take(user.second));
    }
  }
  for (const auto& [signal, taken] : rows) {
    if (taken.names) Q_EMIT namesLearned(signal, *taken.names);
    for (const auto& run : taken.runs) {
      if (run.begins_epoch) Q_EMIT epochBegan(signal);
      if (!run.samples.empty()) Q_EMIT samplesArrived(signal, run.samples);
    }
    if (taken.stale) Q_EMIT wentStale(signal, *taken.stale);
  }
}

void ReplaySignals::deliverValues() {
  std::vector<std::pair<QString, ColumnValues>> values;
  std::vector<std::pair<QString, QString>> refused;
  for (const auto& [path, column] : columns_) {
    if (column.watchers.isEmpty()) continue;
    if (auto newest = column.feed->takeValues()) values.emplace_back(path, *std::move(newest));
    if (const QString why = column.feed->refusal(); !why.isEmpty()) refused.emplace_back(path, why);
  }
  for (const auto& [path, newest] : values) Q_EMIT valuesArrived(path, newest);
  for (const auto& [path, why] : refused) Q_EMIT valuesRefused(path, why);
}

}  // namespace tendon::gui
