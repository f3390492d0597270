#include <tendon/process/telemetry/make_telemetry_client.h>

#include <tendon/process/telemetry/past_rows_reading.h>
#include <tendon/process/telemetry/row_source.h>

#include <map>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon {
namespace {

class ChannelTelemetryClient final : public TelemetryClient {
 public:
  explicit ChannelTelemetryClient(RowSource::Access access) : access_(std::move(access)) {}

  ChannelTelemetryClient(const ChannelTelemetryClient&) = delete;
  ChannelTelemetryClient& operator=(const ChannelTelemetryClient&) = delete;
  ~ChannelTelemetryClient() override {
    for (const auto& [id, subscription] : subscriptions_) subscription->End();
    for (const auto& weak : readings_) {
      if (const auto reading = weak.lock()) reading->End();
    }
    worker_->Stop();
    pulse_->Stop();
    for (const auto& [process, source] : sources_) source->Close();
  }

  Id Subscribe(const TableSubscription& wanted, std::shared_ptr<RowSink> sink) override {
    auto subscription = std::make_shared<RowSubscription>(wanted, std::move(sink));
    const std::scoped_lock lock(mutex_);
    subscriptions_[++last_id_] = subscription;
    worker_->Post(
        [this, subscription] { SourceOf(subscription->wanted().process).Add(subscription); });
    return last_id_;
  }

  void Unsubscribe(Id id) override {
    std::unique_lock lock(mutex_);
    const auto node = subscriptions_.extract(id);
    lock.unlock();
    if (!node) return;
    node.mapped()->End();
    worker_->Post([this, subscription = node.mapped()] {
      SourceOf(subscription->wanted().process).Remove(subscription);
    });
  }

  void ReadPast(const TableSubscription& table, std::chrono::nanoseconds last,
                std::shared_ptr<RowSink> sink, std::function<void(const PastRows&)> done) override {
    auto reading = std::make_shared<PastRowsReading>(table, last, std::move(sink), std::move(done));
    {
      const std::scoped_lock lock(mutex_);
      std::erase_if(readings_, [](const auto& one) { return one.expired(); });
      readings_.push_back(reading);
    }
    worker_->Post(
        [this, reading = std::move(reading)] { SourceOf(reading->process()).ReadPast(reading); });
  }

  void Retry(const std::string& process) override {
    worker_->Post([this, process] {
      const auto found = sources_.find(process);
      if (found != sources_.end()) found->second->Retry();
    });
  }

 private:
  /// Returns the source for a subscription, and creates it if needed. Called on the worker.
  RowSource& SourceOf(const std::string& process) {
    auto& source = sources_[process];
    if (!source) source = std::make_shared<RowSource>(access_, worker_, pulse_, process);
    return *source;
  }

  const RowSource::Access access_;
  const std::shared_ptr<Worker> worker_ = std::make_shared<Worker>("telemetry");
  const std::shared_ptr<Worker> pulse_ = std::make_shared<Worker>("pulse", "telemetry");
  std::map<std::string, std::shared_ptr<RowSource>> sources_;  // used only on the worker
  mutable std::mutex mutex_;
  std::map<Id, std::shared_ptr<RowSubscription>> subscriptions_;
  std::vector<std::weak_ptr<PastRowsReading>> readings_;
  Id last_id_ = 0;
};

}  // namespace

std::unique_ptr<TelemetryClient> MakeTelemetryClient(std::shared_ptr<Middleware> middleware,
                                                     ResolveAddress resolve, Hello mine,
                                                     FindBroker find_broker,
                                                     std::chrono::milliseconds timeout) {
  return std::make_unique<ChannelTelemetryClient>(
      RowSource::Access{.middleware = std::move(middleware),
                        .resolve = std::move(resolve),
                        .hello = std::move(mine),
                        .find_broker = std::move(find_broker),
                        .past_timeout = timeout});
}

}  // namespace tendon
