#include <tendon/middleware/channel_handler.h>

#include <string>

namespace tendon {

void ChannelHandler::OnOpen(const std::shared_ptr<Channel>& /*channel*/, const Hello& /*peer*/) {}

void ChannelHandler::OnRequest(const std::shared_ptr<Channel>& /*channel*/,
                               const FrameHeader& header, std::span<const std::byte> /*body*/,
                               Responder responder) {
  responder.Refuse({ErrorCode::kNotFound, "message " +
                                              std::to_string(static_cast<unsigned>(header.type)) +
                                              " is not understood here"});
}

void ChannelHandler::OnNotice(const std::shared_ptr<Channel>& /*channel*/,
                              const FrameHeader& /*header*/, std::span<const std::byte> /*body*/) {}

std::optional<Error> ChannelHandler::RefusalOfLargeMessage(const Channel& /*channel*/,
                                                           const FrameHeader& /*header*/) {
  return std::nullopt;
}

void ChannelHandler::OnClosed(const std::shared_ptr<Channel>& /*channel*/,
                              const Error& /*reason*/) {}

}  // namespace tendon
