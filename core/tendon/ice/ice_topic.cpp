#include <tendon/ice/ice_topic.h>

#include <tendon/base/log.h>
#include <tendon/ice/bounded_reader.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <exception>
#include <mutex>
#include <utility>

namespace tendon::ice {
namespace {

constexpr std::chrono::milliseconds kBetweenChecks(1000);

/// The state of a topic. It is shared by the IceTopic, the worker and the callbacks of Ice.
class TopicPublisher final : public std::enable_shared_from_this<TopicPublisher> {
 public:
  TopicPublisher(const BrokerConnection& connection, std::string broker, std::string name)
      : connection_(connection), broker_(std::move(broker)), name_(std::move(name)) {}

  Status Publish(std::span<const std::byte> message) {
    if (message.size() > Broadcast::kMaxMessage) return Status::kInvalid;
    const std::size_t size = message.size();
    std::shared_ptr<Ice::ObjectPrx> publisher;
    {
      const std::scoped_lock lock(mutex_);
      if (!publisher_) return Status::kNotConnected;
      if (unsent_ + size > kSendWindow) return Status::kQueueFull;
      unsent_ += size;
      publisher = publisher_;
    }
    thread_local Bytes parameters;
    WriteOnlyParameter(message, parameters);
    const auto* begin = reinterpret_cast<const Ice::Byte*>(parameters.data());
    const std::pair<const Ice::Byte*, const Ice::Byte*> range{begin, begin + parameters.size()};
    const auto sent = [self = shared_from_this(), size](bool /*at once*/) { self->OnSent(size); };
    const auto failed = [self = shared_from_this(), size,
                         publisher](const std::exception_ptr& /*why*/) {
      self->OnSent(size);
      self->Lose(publisher);
    };
    try {
      publisher->ice_invokeAsync(kTopicOperation, Ice::OperationMode::Normal, range, nullptr,
                                 failed, sent);
    } catch (const Ice::Exception&) {
      OnSent(size);
      Lose(publisher);
      return Status::kNotConnected;
    }
    return Status::kQueued;
  }

  /// Checks that the topic exists, and creates it if it is missing. Called in the worker's thread.
  void CheckTopic(const std::weak_ptr<Worker>& worker) {
    {
      const std::scoped_lock lock(mutex_);
      if (has_ended_) return;
    }
    try {
      Make();
    } catch (const Ice::Exception& failure) {
      Lose();
      LogOnce("no broker answers at " + broker_ + " (" + failure.ice_id() + ")");
    }
    if (const auto alive = worker.lock()) {
      alive->PostAfter(kBetweenChecks,
                       [self = shared_from_this(), worker] { self->CheckTopic(worker); });
    }
  }

  void End() {
    std::shared_ptr<IceStorm::TopicPrx> topic;
    {
      const std::scoped_lock lock(mutex_);
      has_ended_ = true;
      publisher_ = nullptr;
      topic = std::exchange(topic_, nullptr);
    }
    Destroy(topic);
  }

 private:
  static void Destroy(const std::shared_ptr<IceStorm::TopicPrx>& topic) {
    try {
      if (topic) topic->destroyAsync(nullptr, [](const std::exception_ptr& /*why*/) {});
    } catch (const Ice::Exception&) {
      // The broker is gone with its topics, or the middleware has ended.
    }
  }

  /// Creates the topic if the broker does not have it, for example after a restart of the broker.
  void Make() {
    const auto manager = connection_.Open(broker_);
    if (!manager) return LogOnce(manager.error().message);
    std::shared_ptr<IceStorm::TopicPrx> topic;
    try {
      topic = (*manager)->create(name_);
    } catch (const IceStorm::TopicExists&) {
      const std::scoped_lock lock(mutex_);
      if (publisher_) return;
    }
    if (!topic) topic = (*manager)->retrieve(name_);
    const auto reached = connection_.Reach(topic);
    if (!reached) return LogOnce(reached.error().message);
    topic = Ice::uncheckedCast<IceStorm::TopicPrx>(*reached);
    if (!Keep(topic)) return Destroy(topic);
    const auto publisher = connection_.Reach(topic->getPublisher());
    if (!publisher) return LogOnce(publisher.error().message);
    const std::scoped_lock lock(mutex_);
    if (has_ended_) return;
    publisher_ = (*publisher)->ice_invocationTimeout(-1)->ice_oneway();
    warning_.clear();
  }

  /// Stores the topic. Returns false after End(); then the caller must destroy the topic.
  bool Keep(const std::shared_ptr<IceStorm::TopicPrx>& topic) {
    const std::scoped_lock lock(mutex_);
    if (!has_ended_) topic_ = topic;
    return !has_ended_;
  }

  void OnSent(std::size_t size) {
    const std::scoped_lock lock(mutex_);
    unsent_ -= size;
  }

  void Lose() {
    const std::scoped_lock lock(mutex_);
    publisher_ = nullptr;
  }

  /// Called when `publisher` has failed. Does nothing if the topic now has another publisher.
  void Lose(const std::shared_ptr<Ice::ObjectPrx>& publisher) {
    const std::scoped_lock lock(mutex_);
    if (publisher_ == publisher) publisher_ = nullptr;
  }

  /// Logs the reason, unless the last logged reason was the same.
  void LogOnce(const std::string& reason) {
    if (std::exchange(warning_, reason) != reason) Log(LogLevel::kWarning, "broker", reason);
  }

  const BrokerConnection& connection_;  // used only on the worker
  const std::string broker_;
  const std::string name_;
  std::string warning_;  // used only on the worker
  std::mutex mutex_;
  bool has_ended_ = false;
  std::shared_ptr<IceStorm::TopicPrx> topic_;
  std::shared_ptr<Ice::ObjectPrx> publisher_;  // set while connected
  std::size_t unsent_ = 0;                     // bytes not sent yet
};

class IceTopic final : public Broadcast::Topic {
 public:
  explicit IceTopic(std::shared_ptr<TopicPublisher> publisher) : publisher_(std::move(publisher)) {}
  ~IceTopic() override { publisher_->End(); }

  Status Publish(std::span<const std::byte> message) override {
    return publisher_->Publish(message);
  }

 private:
  const std::shared_ptr<TopicPublisher> publisher_;
};

}  // namespace

std::unique_ptr<Broadcast::Topic> MakeTopic(const BrokerConnection& connection,
                                            std::shared_ptr<Worker> worker, std::string broker,
                                            std::string name) {
  auto publisher = std::make_shared<TopicPublisher>(connection, std::move(broker), std::move(name));
  worker->Post([publisher, weak = std::weak_ptr(worker)] { publisher->CheckTopic(weak); });
  return std::make_unique<IceTopic>(std::move(publisher));
}

}  // namespace tendon::ice
