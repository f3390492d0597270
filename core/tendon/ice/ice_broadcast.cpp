#include <tendon/ice/ice_broadcast.h>

#include <tendon/base/os/process.h>
#include <tendon/ice/bounded_reader.h>
#include <tendon/ice/broker.h>
#include <tendon/ice/ice_topic.h>
#include <tendon/ice/settings.h>
#include <tendon/ice/tls.h>

#include <exception>
#include <mutex>
#include <span>
#include <thread>
#include <utility>
#include <vector>

namespace tendon::ice {
namespace {

/// Passes the messages of a topic to a handler. Without TLS, only the broker can send messages to
/// this servant, because its name is a random number that only the broker knows. With TLS, the
/// servant accepts only messages from the broker.
class SubscriberServant final : public Ice::BlobjectArray {
 public:
  SubscriberServant(Broadcast::MessageHandler handler, bool is_certified)
      : handler_(std::move(handler)), is_certified_(is_certified) {}

  bool ice_invoke(std::pair<const Ice::Byte*, const Ice::Byte*> parameters,
                  std::vector<Ice::Byte>& reply, const Ice::Current& current) override {
    const std::scoped_lock lock(mutex_);
    if (is_certified_ && !IsOfBroker(current.con)) {
      throw Ice::ObjectNotExistException(__FILE__, __LINE__, current.id, current.facet,
                                         current.operation);
    }
    if (current.requestId != 0) reply = {6, 0, 0, 0, 1, 1};
    const auto message =
        ReadOnlyParameter(std::as_bytes(std::span(parameters.first, parameters.second)));
    if (current.operation != kTopicOperation || !message) {
      throw Ice::MarshalException("tendon", 0, "no message of a topic");
    }
    handler_(*message);
    return true;
  }

 private:
  /// Returns true if the connection comes from the broker. Stores the last good connection, so that
  /// each connection is checked only once.
  bool IsOfBroker(const std::shared_ptr<Ice::Connection>& connection) {
    if (connection == good_.lock()) return true;
    const auto certificate = CertificateOf(*connection);
    if (!certificate || certificate->name != kBrokerName) return false;
    good_ = connection;
    return true;
  }

  const Broadcast::MessageHandler handler_;
  const bool is_certified_;
  std::mutex mutex_;
  std::weak_ptr<Ice::Connection> good_;
};

/// A subscription to a topic. Its destructor ends the subscription.
class IceSubscription final : public Broadcast::Subscription {
 public:
  IceSubscription(std::shared_ptr<Ice::ObjectAdapter> adapter,
                  std::shared_ptr<IceStorm::TopicPrx> topic,
                  std::shared_ptr<Ice::ObjectPrx> listener)
      : adapter_(std::move(adapter)), topic_(std::move(topic)), subscriber_(std::move(listener)) {}

  ~IceSubscription() override {
    try {
      adapter_->remove(subscriber_->ice_getIdentity());
      topic_->unsubscribeAsync(subscriber_, nullptr, [](const std::exception_ptr&) {});
    } catch (const Ice::Exception&) {
      // The broker is gone with its subscriptions, or the middleware has ended.
    }
  }

 private:
  const std::shared_ptr<Ice::ObjectAdapter> adapter_;
  const std::shared_ptr<IceStorm::TopicPrx> topic_;
  const std::shared_ptr<Ice::ObjectPrx> subscriber_;
};

/// Finds the topic; null if it does not exist yet.
std::shared_ptr<IceStorm::TopicPrx> Find(IceStorm::TopicManagerPrx& manager,
                                         const std::string& name) {
  try {
    return manager.retrieve(name);
  } catch (const IceStorm::NoSuchTopic&) {
    return nullptr;
  }
}

/// Returns the local address of a connection, with or without TLS.
std::string LocalHostOf(const Ice::Connection& connection) {
  auto info = connection.getInfo();
  while (info->underlying) info = info->underlying;
  return std::dynamic_pointer_cast<Ice::IPConnectionInfo>(info)->localAddress;
}

/// Returns a random number that cannot be guessed, as text.
std::string NumberText() {
  return std::to_string(os::RandomNumber()) + "-" + std::to_string(os::RandomNumber());
}

Error NotReached(const std::string& broker, const Ice::Exception& failure) {
  return {ErrorCode::kUnreachable, "no broker answers at " + broker + " (" + failure.ice_id() +
                                       "); to start a broker: gcm broker"};
}

}  // namespace

IceBroadcast::IceBroadcast(std::shared_ptr<Ice::Communicator> communicator, bool is_certified)
    : communicator_(std::move(communicator)), connection_(communicator_, is_certified) {}

IceBroadcast::~IceBroadcast() {
  if (worker_) worker_->Stop();
}

std::unique_ptr<Broadcast::Topic> IceBroadcast::OpenTopic(const std::string& broker,
                                                          const std::string& name) {
  const std::scoped_lock lock(mutex_);
  if (!worker_) worker_ = std::make_shared<Worker>("broker");
  return MakeTopic(connection_, worker_, broker, name);
}

Result<std::unique_ptr<Broadcast::Subscription>> IceBroadcast::Subscribe(
    const std::string& broker, const std::string& name, MessageHandler handler,
    std::chrono::milliseconds timeout) {
  constexpr std::chrono::milliseconds kPause(10);
  const SteadyTime deadline = SteadyClock().Now() + timeout;
  try {
    const auto manager = connection_.Open(broker);
    if (!manager) return manager.error();
    auto topic = Find(**manager, name);
    for (; !topic && SteadyClock().Now() < deadline; topic = Find(**manager, name)) {
      std::this_thread::sleep_for(kPause);
    }
    if (!topic) {
      return Error{ErrorCode::kTimeout,
                   "the broker at " + broker + " did not create topic '" + name + "' in time"};
    }
    const auto reached = connection_.Reach(topic);
    if (!reached) return reached.error();
    topic = Ice::uncheckedCast<IceStorm::TopicPrx>(*reached);
    const auto adapter = AdapterAt(LocalHostOf(*topic->ice_getConnection()));
    const Ice::Identity identity{NumberText(), "listener"};
    const auto listener = adapter
                              ->add(std::make_shared<SubscriberServant>(std::move(handler),
                                                                        connection_.is_certified()),
                                    identity)
                              ->ice_oneway();
    auto subscription = std::make_unique<IceSubscription>(adapter, topic, listener);
    topic->subscribeAndGetPublisher({}, listener);
    return std::unique_ptr<Subscription>(std::move(subscription));
  } catch (const Ice::Exception& failure) {
    return NotReached(broker, failure);
  }
}

std::shared_ptr<Ice::ObjectAdapter> IceBroadcast::AdapterAt(const std::string& host) {
  const std::scoped_lock lock(mutex_);
  auto& adapter = adapters_[host];
  if (!adapter) {
    const std::string transport = connection_.is_certified() ? "ssl" : "tcp";
    const std::string name = "listeners-" + host;
    // The adapter has a separate thread, because this thread calls the handlers of subscribers.
    communicator_->getProperties()->setProperty(name + ".ThreadPool.Size", "1");
    communicator_->getProperties()->setProperty(name + ".ThreadPool.SizeMax", "1");
    const auto made =
        MakeListeningAdapter(*communicator_, name, transport + " -h \"" + host + "\" -p 0");
    made->activate();
    adapter = made;
  }
  return adapter;
}

}  // namespace tendon::ice
