#pragma once

#include <tendon/base/result.h>
#include <tendon/base/status.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace tendon {

/// Multicast through a broker: one process publishes messages, and any number of processes receive
/// them. The broker does not wait for a slow receiver. The receiver then misses messages without
/// being informed, so messages must contain sequence numbers. Thread-safe.
///
/// This class is only the interface. The implementation is ice/ice_broadcast.h, with IceStorm as
/// the broker. If the rows of a state table are sent through the broker, they are one topic
/// (RowTopic in process/telemetry/row_topic.h). `gcm broker` runs the broker (docs/broker.md).
class Broadcast {
 public:
  /// A topic on the side of its publisher. The topic is removed when this object is destroyed.
  /// After a restart of the broker, it is created again.
  class Topic {
   public:
    Topic() = default;
    Topic(const Topic&) = delete;
    Topic& operator=(const Topic&) = delete;
    virtual ~Topic() = default;
    /// Publishes a message; never blocks. Fails with kNotConnected while the broker does not have
    /// the topic, with kQueueFull if the broker is too slow, and with kInvalid if the message is
    /// larger than kMaxMessage.
    virtual Status Publish(std::span<const std::byte> message) = 0;
  };

  /// A subscription to a topic. After it is destroyed, a few more messages may arrive.
  class Subscription {
   public:
    Subscription() = default;
    Subscription(const Subscription&) = delete;
    Subscription& operator=(const Subscription&) = delete;
    virtual ~Subscription() = default;
  };

  /// Receives the messages in order, in a thread of the middleware, one call at a time. The bytes
  /// are untrusted.
  using MessageHandler = std::function<void(std::span<const std::byte> message)>;

  static constexpr std::size_t kMaxMessage = std::size_t{256} << 10U;

  Broadcast() = default;
  Broadcast(const Broadcast&) = delete;
  Broadcast& operator=(const Broadcast&) = delete;
  virtual ~Broadcast() = default;

  /// Creates a topic for publishing. Returns at once; the broker has the topic only a little later.
  /// `name` must be unique.
  virtual std::unique_ptr<Topic> OpenTopic(const std::string& broker, const std::string& name) = 0;

  /// Subscribes to a topic. Blocks until the broker has confirmed the subscription, which includes
  /// waiting for a topic that does not exist yet. Fails with kUnreachable, with kTimeout, or with
  /// kDenied if the broker belongs to another user.
  virtual Result<std::unique_ptr<Subscription>> Subscribe(const std::string& broker,
                                                          const std::string& name,
                                                          MessageHandler handler,
                                                          std::chrono::milliseconds timeout) = 0;
};

}  // namespace tendon
