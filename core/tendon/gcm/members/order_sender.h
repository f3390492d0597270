#pragma once

#include <tendon/gcm/members/deferred_actions.h>
#include <tendon/gcm/members/registry.h>
#include <tendon/middleware/body.h>
#include <tendon/process/ask.h>

#include <chrono>
#include <functional>
#include <string>
#include <utility>

namespace tendon::server {

/// Sends orders to processes, and sends the replies to the clients that requested the orders. All
/// functions must be called while the owner's lock is held. Orders and replies are sent after the
/// lock is released; then `done` is called once.
class OrderSender {
 public:
  template <typename T>
  using Done = std::function<void(Result<T>)>;

  /// `worker` provides timeouts.
  OrderSender(const Registry& registry, DeferredActions& deferred, Worker& worker)
      : registry_(registry), deferred_(deferred), worker_(worker) {}

  template <typename T>
  void Reply(Done<T> done, Result<T> result) {
    deferred_.Add([done = std::move(done), result = std::move(result)] { done(result); });
  }

  /// Sends an order. `done` gets the reply. Errors: kFailed if the process is not available;
  /// kTimeout if no reply arrives within `longest`.
  template <typename T, Message Body>
  void Send(MessageType type, const std::string& process, const Body& body,
            std::chrono::milliseconds longest, Done<T> done) {
    const auto channel = registry_.ChannelOf(process);
    if (!channel) {
      return Reply(std::move(done), Result<T>(Error{ErrorCode::kFailed,
                                                    "process '" + process + "' is not available"}));
    }
    deferred_.Add([&worker = worker_, channel, type, body, longest, done = std::move(done)] {
      Ask<T>(worker, channel, type, body, longest, done);
    });
  }

 private:
  const Registry& registry_;
  DeferredActions& deferred_;
  Worker& worker_;
};

}  // namespace tendon::server
