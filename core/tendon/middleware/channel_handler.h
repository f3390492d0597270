#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/responder.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

namespace tendon {

class Channel;

/// Receives the messages of a channel. Called in a thread of the middleware, one call at a time for
/// each channel. Must not block. If it throws, the exception is logged and the request is refused.
class ChannelHandler {
 public:
  ChannelHandler() = default;
  ChannelHandler(const ChannelHandler&) = delete;
  ChannelHandler& operator=(const ChannelHandler&) = delete;
  virtual ~ChannelHandler() = default;

  /// Called when the peer is authenticated and before its first message. Channel::Open() returns
  /// after this call.
  virtual void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& peer);

  /// Called for each request of the peer. By default, refuses it. The body is valid only during the
  /// call.
  virtual void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                         std::span<const std::byte> body, Responder responder);

  /// Called for each notice of the peer. By default, does nothing. The body is valid only during
  /// the call.
  virtual void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                        std::span<const std::byte> body);

  /// Called with the header when the first part of a large message has arrived. If this function
  /// returns an error, the message is discarded; if the message is a request, it is refused with
  /// the error. By default, accepts all messages.
  virtual std::optional<Error> RefusalOfLargeMessage(const Channel& channel,
                                                     const FrameHeader& header);

  /// Called exactly once for every link that was opened, as the last call, even if the handshake
  /// failed. The channel then releases the handler.
  virtual void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason);
};

}  // namespace tendon
