#include <tendon/process/channel_opening.h>

#include <exception>
#include <utility>

namespace tendon {
namespace {

OpenedChannel Open(Middleware& middleware, const ChannelRequest& wanted) {
  try {
    return Channel::Open(middleware, wanted.address, wanted.hello, wanted.handler, wanted.timeout);
  } catch (const std::exception& failure) {  // for example, no memory or no thread
    return Error{ErrorCode::kFailed, failure.what()};
  }
}

/// Passes an opened channel to the worker, which may have stopped.
class ChannelHandoff {
 public:
  ChannelHandoff(Middleware& middleware, const ChannelRequest& wanted)
      : channel_(Open(middleware, wanted)) {}
  ChannelHandoff(const ChannelHandoff&) = delete;
  ChannelHandoff& operator=(const ChannelHandoff&) = delete;
  ~ChannelHandoff() {
    if (channel_ && !is_taken_) (*channel_)->Close();
  }

  [[nodiscard]] const OpenedChannel& Take() {
    is_taken_ = true;
    return channel_;
  }

 private:
  const OpenedChannel channel_;
  bool is_taken_ = false;
};

}  // namespace

void OpenChannel(const ProcessContext& context, const ChannelRequest& wanted,
                 std::function<void(const OpenedChannel&)> done) {
  wanted.opener->Post(
      [middleware = context.middleware, worker = context.worker, wanted, done = std::move(done)] {
        const auto handoff = std::make_shared<ChannelHandoff>(*middleware, wanted);
        worker->Post([handoff, done] { done(handoff->Take()); });
      });
}

}  // namespace tendon
