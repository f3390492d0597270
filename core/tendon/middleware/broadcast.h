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

/// Multicast: one process publishes, any number of others receive, through a broker. The broker
/// does not wait for a slow receiver, and does not report the messages that it misses. So messages
/// must carry sequence numbers. Thread-safe.
///
/// Broadcast is the interface; the broker is IceStorm, reached through ice/ice_broadcast.h. The
/// rows of a table that go through the broker are one topic (RowTopic in
/// process/telemetry/row_stream.h). `gcm broker` runs the broker (docs/broker.md).
class Broadcast {
 public:
  /// The publisher's end of a topic. The topic ends when this object is destroyed, and is created
  /// again after a restart of the broker.
  class Topic {
   public:
    Topic() = default;
    Topic(const Topic&) = delete;
    Topic& operator=(const Topic&) = delete;
    virtual ~Topic() = default;
    /// Never blocks. kNotConnected while the broker has no such topic, kQueueFull if the broker is
    /// too slow, kInvalid for a message above kMaxMessage.
    virtual Status Publish(std::span<const std::byte> message) = 0;
  };

  /// A subscriber's end. Messages stop soon after it is destroyed.
  class Subscription {
   public:
    Subscription() = default;
    Subscription(const Subscription&) = delete;
    Subscription& operator=(const Subscription&) = delete;
    virtual ~Subscription() = default;
  };

  /// Called in a thread of the middleware, one call at a time, in order. The bytes are untrusted.
  using MessageHandler = std::function<void(std::span<const std::byte> message)>;

  static constexpr std::size_t kMaxMessage = std::size_t{256} << 10U;

  Broadcast() = default;
  Broadcast(const Broadcast&) = delete;
  Broadcast& operator=(const Broadcast&) = delete;
  virtual ~Broadcast() = default;

  /// Publishes a topic. Returns at once; the broker creates the topic soon after. `name` must be
  /// unique.
  virtual std::unique_ptr<Topic> OpenTopic(const std::string& broker, const std::string& name) = 0;

  /// Subscribes to a topic; blocks until the broker has confirmed. If the topic does not exist yet,
  /// waits for it. Errors: kUnreachable, kDenied if the broker belongs to another user, kTimeout.
  virtual Result<std::unique_ptr<Subscription>> Subscribe(const std::string& broker,
                                                          const std::string& name,
                                                          MessageHandler handler,
                                                          std::chrono::milliseconds timeout) = 0;
};

}  // namespace tendon
