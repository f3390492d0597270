#include <tendon/process/client/peer_link.h>
#include <tendon/process/schema_exchange.h>
#include <tendon/process/watch_over.h>
#include <tendon/proxy/messages.h>

namespace tendon {

Result<std::shared_ptr<PeerLink>> PeerLink::Open(const ProcessContext& context,
                                                 PeerListener& listener, const std::string& process,
                                                 const std::string& address) {
  constexpr std::chrono::milliseconds kOpenTimeout(800);
  auto link = std::make_shared<PeerLink>(context.worker, listener);
  Hello hello = context.hello;
  hello.wanted = process;
  hello.session = 0;  // it is for the GCM alone
  auto channel = Channel::Open(*context.middleware, address, hello, link, kOpenTimeout);
  if (!channel) {
    return Error{channel.error().code, "process '" + process + "' cannot be reached at " + address +
                                           ": " + channel.error().message};
  }
  link->channel_ = *std::move(channel);
  WatchOver(context.worker, link->channel_,
            [weak = std::weak_ptr(link)](SteadyTime sent, SteadyTime, SteadyTime arrived) {
              const auto measured = weak.lock();
              if (!measured) return;
              measured->round_trip_.Set(arrived - sent);
            });
  return link;
}

void PeerLink::OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                         std::span<const std::byte> body, Responder responder) {
  if (header.type == message::kGetSchemas) return AnswerSchemas(body, responder);
  ChannelHandler::OnRequest(channel, header, body, std::move(responder));
}

void PeerLink::OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                        std::span<const std::byte> body) {
  if (header.type == message::kEvents) {
    return ForEachCall(body, [this](std::uint32_t handler, std::span<const std::byte> value) {
      const auto [proxy, offset] = handles_.Find(handler);
      if (proxy && offset > 0) proxy->OnEvent(offset - 1, value);
    });
  }
  const auto [proxy, offset] = handles_.Find(header.handle);
  if (!proxy || offset > 0) return;  // closed meanwhile
  if (header.type == message::kCredit) {
    const auto credit = DecodeBody<message::Credit>(body);
    if (!credit || !proxy->OnCredit(*credit)) return;
    worker_->Post([self = shared_from_this()] { self->listener_.OnServerChanged(); });
  } else if (header.type == message::kEventsLost) {
    const auto events = DecodeBody<message::EventsLost>(body);
    if (events) proxy->OnEventsLost(*events);
  } else if (header.type == message::kInterfaceClosed) {
    proxy->Sever();
    worker_->Post([self = shared_from_this(), handle = header.handle,
                   reason = ReadRefusal(body, "the peer")] {
      self->listener_.OnInterfaceClosed(*self, handle, reason);
    });
  }
}

void PeerLink::OnClosed(const std::shared_ptr<Channel>& /*channel*/, const Error& reason) {
  for (const auto& proxy : handles_.objects()) proxy->Sever();
  worker_->Post(
      [self = shared_from_this(), reason] { self->listener_.OnLinkClosed(*self, reason); });
}

}  // namespace tendon
