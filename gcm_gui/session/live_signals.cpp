#include <gcm_gui/session/live_signals.h>

#include <tendon/base/path.h>

#include <chrono>
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

LiveSignals::LiveSignals(TelemetryClient& telemetry, QObject* parent)
    : ColumnSignals(parent), telemetry_(telemetry) {
  connect(&rows_timer_, &QTimer::timeout, this, &LiveSignals::drain);
  connect(&values_timer_, &QTimer::timeout, this, &LiveSignals::drainValues);
  connect(&sweep_timer_, &QTimer::timeout, this, &LiveSignals::dropUnused);
  rows_timer_.start(kRowsPeriod);
  values_timer_.start(kValuesPeriod);
  sweep_timer_.start(kSweepPeriod);
}

LiveSignals::~LiveSignals() {
  for (const auto& [path, subscription] : subscriptions_) end(subscription);
}

void LiveSignals::end(const Subscription& subscription) {
  telemetry_.Unsubscribe(subscription.id);
  if (subscription.initial) telemetry_.Unsubscribe(*subscription.initial);
}

bool LiveSignals::begin(const QString& column, const std::shared_ptr<ColumnFeed>& feed) {
  const auto parsed = ParsePath(column.toStdString());
  if (!parsed.ok() || parsed->member.empty()) return false;
  Subscription& subscription = subscriptions_[column];
  subscription.table = {parsed->process, parsed->component, parsed->interface, {parsed->member}};
  subscription.id = telemetry_.Subscribe(subscription.table, feed);
  return true;
}

void LiveSignals::onWatched(const QString& path) {
  const Column& column = columns().at(path);
  Subscription& subscription = subscriptions_.at(path);
  // The row of this column may have been dropped. Requests the row again.
  if (column.feed->takeRenewed()) endInitialRow(subscription);
  if (subscription.initial && column.feed->hasRow()) endInitialRow(subscription);
  if (subscription.initial || column.watchers.isEmpty() || !column.feed->lacksRow()) return;
  TableSubscription wanted = subscription.table;
  wanted.rows.delivery = RowDelivery::kNewest;
  subscription.initial =
      telemetry_.Subscribe(wanted, std::make_shared<InitialRowSink>(column.feed));
}

void LiveSignals::endInitialRow(Subscription& subscription) {
  if (!subscription.initial) return;
  telemetry_.Unsubscribe(*std::exchange(subscription.initial, std::nullopt));
}

void LiveSignals::retry(const QString& column) {
  telemetry_.Retry(column.section('/', 0, 0).toStdString());
}

void LiveSignals::drainValues() {
  for (const auto& [path, subscription] : subscriptions_) onWatched(path);
  deliverNewest();
}

void LiveSignals::dropUnused() {
  for (auto it = subscriptions_.begin(); it != subscriptions_.end();) {
    auto& [path, subscription] = *it;
    subscription.idle_sweeps = columns().at(path).isUsed() ? 0 : subscription.idle_sweeps + 1;
    if (subscription.idle_sweeps < kIdleSweeps) {
      ++it;
      continue;
    }
    end(subscription);
    columns().erase(path);
    it = subscriptions_.erase(it);
  }
}

}  // namespace tendon::gui
