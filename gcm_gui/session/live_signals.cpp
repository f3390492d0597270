#include <gcm_gui/models/text.h>
#include <gcm_gui/session/column_feed.h>
#include <gcm_gui/session/live_signals.h>

#include <utility>
#include <vector>

namespace tendon::gui {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kRowsPeriod{33};
constexpr milliseconds kValuesPeriod{100};
constexpr milliseconds kSweepPeriod{1000};
constexpr int kIdleSweeps = 3;

/// Receives the last row that was written before the subscription. A subscription to every row
/// delivers only new rows.
class InitialRowSink final : public RowSink {
 public:
  explicit InitialRowSink(std::shared_ptr<ColumnFeed> feed) : feed_(std::move(feed)) {}

  void OnSubscribed(const std::vector<Schema>& /*columns*/) override {}
  void OnRows(const RowBatch& batch) override { feed_->takeInitialRow(batch); }
  void OnStale(const Error& /*reason*/) override {}

 private:
  const std::shared_ptr<ColumnFeed> feed_;
};

}  // namespace

QString ColumnPathOf(const QString& signal) {
  auto path = ParsePath(signal.toStdString());
  if (!path.ok() || path->member.empty()) return {};
  path->field.clear();
  return ToQString(ToString(*path));
}

LiveSignals::LiveSignals(TelemetryClient& telemetry, QObject* parent)
    : SignalSource(parent), telemetry_(telemetry) {
  connect(&rows_timer_, &QTimer::timeout, this, &LiveSignals::drain);
  connect(&values_timer_, &QTimer::timeout, this, &LiveSignals::drainValues);
  connect(&sweep_timer_, &QTimer::timeout, this, &LiveSignals::dropUnused);
  rows_timer_.start(kRowsPeriod);
  values_timer_.start(kValuesPeriod);
  sweep_timer_.start(kSweepPeriod);
}

LiveSignals::~LiveSignals() {
  for (const auto& [path, column] : columns_) end(column);
}

void LiveSignals::end(const Column& column) {
  telemetry_.Unsubscribe(column.id);
  if (column.initial) telemetry_.Unsubscribe(*column.initial);
}

LiveSignals::Column* LiveSignals::open(const QString& path) {
  if (const auto it = columns_.find(path); it != columns_.end()) return &it->second;
  const auto parsed = ParsePath(path.toStdString());
  if (!parsed.ok() || parsed->member.empty()) return nullptr;
  Column& column = columns_[path];
  column.feed = std::make_shared<ColumnFeed>();
  column.table = {parsed->process, parsed->component, parsed->interface, {parsed->member}};
  column.id = telemetry_.Subscribe(column.table, column.feed);
  return &column;
}

void LiveSignals::subscribe(const QString& signal) {
  const QString path = ColumnPathOf(signal);
  Column* column = open(path);
  if (column == nullptr) return;
  User& user = column->users[signal];
  if (++user.count > 1) return;
  user.field = signal.mid(path.size()).toStdString();
  column->feed->tap(user.field);
}

void LiveSignals::release(const QString& signal) {
  const auto it = columns_.find(ColumnPathOf(signal));
  if (it == columns_.end()) return;
  const auto user = it->second.users.find(signal);
  if (user == it->second.users.end() || --user->second.count > 0) return;
  it->second.feed->untap(user->second.field);
  it->second.users.erase(user);
}

void LiveSignals::watch(const QObject* owner, const QSet<QString>& columns) {
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
    requestInitialRow(*column);
  }
}

void LiveSignals::requestInitialRow(Column& column) {
  // The row of this column may have been dropped. Requests the row again.
  if (column.feed->takeRenewed()) endInitialRow(column);
  if (column.initial && column.feed->hasRow()) endInitialRow(column);
  if (column.initial || column.watchers.isEmpty() || !column.feed->lacksRow()) return;
  TableSubscription wanted = column.table;
  wanted.rows.delivery = RowDelivery::kNewest;
  column.initial = telemetry_.Subscribe(wanted, std::make_shared<InitialRowSink>(column.feed));
}

void LiveSignals::endInitialRow(Column& column) {
  if (column.initial) telemetry_.Unsubscribe(*std::exchange(column.initial, std::nullopt));
}

RowLosses LiveSignals::losses(const QString& signal) const {
  const auto it = columns_.find(ColumnPathOf(signal));
  return it == columns_.end() ? RowLosses{} : it->second.feed->losses();
}

void LiveSignals::retry(const QString& column) {
  telemetry_.Retry(column.section('/', 0, 0).toStdString());
}

void LiveSignals::drain() {
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

void LiveSignals::drainValues() {
  QList<std::pair<QString, ColumnValues>> arrived;
  QList<std::pair<QString, QString>> refused;
  for (auto& [path, column] : columns_) {
    requestInitialRow(column);
    if (column.watchers.isEmpty()) continue;
    if (auto values = column.feed->takeValues()) arrived.append({path, std::move(*values)});
    const QString refusal = column.feed->refusal();
    if (!refusal.isEmpty()) refused.append({path, refusal});
  }
  for (const auto& [path, values] : arrived) Q_EMIT valuesArrived(path, values);
  for (const auto& [path, reason] : refused) Q_EMIT valuesRefused(path, reason);
}

void LiveSignals::dropUnused() {
  for (auto it = columns_.begin(); it != columns_.end();) {
    Column& column = it->second;
    column.idle_sweeps = column.used() ? 0 : column.idle_sweeps + 1;
    if (column.idle_sweeps < kIdleSweeps) {
      ++it;
      continue;
    }
    end(column);
    it = columns_.erase(it);
  }
}

}  // namespace tendon::gui
