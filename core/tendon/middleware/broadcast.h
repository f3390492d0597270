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
class FanOut {
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
  class Reception {
   public:
    Reception() = default;
    Reception(const Reception&) = delete;
    Reception& operator=(const Reception&) = delete;
    virtual ~Reception() = default;
  };

  /// Called in a thread of the middleware, one call at a time, in order. The bytes are untrusted.
  using Hear = std::function<void(std::span<const std::byte> message)>;

  static constexpr std::size_t kMaxMessage = std::size_t{256} << 10U;

  FanOut() = default;
  FanOut(const FanOut&) = delete;
  FanOut& operator=(const FanOut&) = delete;
  virtual ~FanOut() = default;

  /// Publishes a topic. Returns at once; the broker creates the topic soon after. `name` must be
  /// unique.
  virtual std::unique_ptr<Topic> Speak(const std::string& broker, const std::string& name) = 0;

  /// Subscribes to a topic; blocks until the broker has confirmed. If the topic does not exist yet,
  /// waits for it. Errors: kUnreachable, kDenied if the broker belongs to another user, kTimeout.
  virtual Result<std::unique_ptr<Reception>> Listen(const std::string& broker,
                                                    const std::string& name, Hear hear,
                                                    std::chrono::milliseconds timeout) = 0;
};

}  // namespace tendon
