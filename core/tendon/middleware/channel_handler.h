#pragma once

#include <tendon/base/result.h>
#include <tendon/middleware/frame.h>
#include <tendon/middleware/hello.h>
#include <tendon/middleware/requests/responder.h>

#include <memory>
#include <optional>
#include <span>

namespace tendon {

class Channel;

/// What one end of a channel does with what arrives; called in a thread of the middleware, one at a
/// time for a channel. Must not block. What it throws is logged, and the request refused.
class ChannelHandler {
 public:
  ChannelHandler() = default;
  ChannelHandler(const ChannelHandler&) = delete;
  ChannelHandler& operator=(const ChannelHandler&) = delete;
  virtual ~ChannelHandler() = default;

  /// The peer's Hello was accepted; requests may follow. Before Channel::Open() returns.
  virtual void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& peer);

  /// Unless overridden, refuses. The body is valid during the call.
  virtual void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                         std::span<const std::byte> body, Responder responder);

  /// Unless overridden, does nothing. The body is valid during the call.
  virtual void OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                        std::span<const std::byte> body);

  /// Why a large message is refused that begins now, of which there is nothing but the header:
  /// nothing of it is kept then, and a request is refused so. Unless overridden, all are taken.
  virtual std::optional<Error> WhyNotTaken(const Channel& channel, const FrameHeader& header);

  /// Exactly once, last, also when the handshake failed: for every link that stood. The channel
  /// forgets the handler afterwards.
  virtual void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason);
};

}  // namespace tendon
