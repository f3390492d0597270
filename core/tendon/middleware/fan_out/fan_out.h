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

/// What a process says once and any number of others hear, by way of a broker, which holds up
/// nobody for one who does not listen: that one misses messages, and nobody tells it. So messages
/// must carry numbers. Thread-safe.
class FanOut {
 public:
  /// The speaker's end of a topic, which ends with it. Made anew where the broker was.
  class Topic {
   public:
    Topic() = default;
    Topic(const Topic&) = delete;
    Topic& operator=(const Topic&) = delete;
    virtual ~Topic() = default;
    /// Never blocks. kNotConnected while there is no topic at the broker, kQueueFull where that
    /// does not keep up, kInvalid for a message of over kMaxMessage.
    virtual Status Publish(std::span<const std::byte> message) = 0;
  };

  /// A listener's end: hears nothing more a little after it ended.
  class Reception {
   public:
    Reception() = default;
    Reception(const Reception&) = delete;
    Reception& operator=(const Reception&) = delete;
    virtual ~Reception() = default;
  };

  /// In a thread of the middleware, one call at a time, in order. The bytes come from anybody.
  using Hear = std::function<void(std::span<const std::byte> message)>;

  static constexpr std::size_t kMaxMessage = std::size_t{256} << 10U;

  FanOut() = default;
  FanOut(const FanOut&) = delete;
  FanOut& operator=(const FanOut&) = delete;
  virtual ~FanOut() = default;

  /// Returns at once; the topic comes to be at the broker soon. `name` is nobody else's.
  virtual std::unique_ptr<Topic> Speak(const std::string& broker, const std::string& name) = 0;

  /// Blocks until the broker has us among the listeners of a topic; waits for that to come to be.
  /// kUnreachable, kDenied where the broker is not ours, kTimeout.
  virtual Result<std::unique_ptr<Reception>> Listen(const std::string& broker,
                                                    const std::string& name, Hear hear,
                                                    std::chrono::milliseconds timeout) = 0;
};

}  // namespace tendon
