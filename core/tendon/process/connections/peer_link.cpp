#include <tendon/process/connections/peer_link.h>

#include <tendon/process/ask.h>
#include <tendon/process/channel_opening.h>
#include <tendon/process/heartbeat.h>
#include <tendon/process/schema_exchange.h>
#include <tendon/process/telemetry/row_batch.h>
#include <tendon/proxy/connection_messages.h>
#include <tendon/state/state_table.h>

#include <string>
#include <utility>

namespace tendon {
namespace {

constexpr std::chrono::hours kAsLongAsTheLink(24 * 365);

using Done = std::function<void(const OpenedInterface&)>;

OpenedInterface MakeProxy(const std::shared_ptr<NetworkThread>& network, const PeerLink& link,
                          const Result<message::OpenInterfaceReply>& reply,
                          const InterfaceRequest& wanted, const PeerLink::MirroredValues& copies) {
  if (!reply) return reply.error();
  const std::shared_ptr<Channel>& channel = link.channel();
  ProvidedInterfaceProxy::Remote remote{.channel = channel,
                                        .opened = *reply,
                                        .name = wanted.open.provided,
                                        .mirrored = {},
                                        .executor = wanted.executor};
  for (std::size_t i = 0; i < copies.size(); ++i) remote.mirrored[wanted.mirrored[i]] = copies[i];
  try {
    return std::make_shared<ProvidedInterfaceProxy>(network, remote, wanted.open.description,
                                                    wanted.read_deadline);
  } catch (const ConfigurationError& error) {
    (void)channel->Notify(message::kCloseInterface, reply->handle, Bytes());
    return Error{ErrorCode::kInvalid,
                 channel->peer().name + " sent an invalid reply: " + error.what()};
  }
}

void Open(const std::shared_ptr<NetworkThread>& network, const std::shared_ptr<PeerLink>& link,
          const InterfaceRequest& wanted, const PeerLink::MirroredValues& copies,
          const Done& done) {
  const auto on_reply = [network, link, wanted, copies,
                         done](const Result<message::OpenInterfaceReply>& reply) {
    const OpenedInterface proxy = MakeProxy(network, *link, reply, wanted, copies);
    if (proxy) link->handles().Put(wanted.open.handle, *proxy);
    done(proxy);
  };
  const std::shared_ptr<Channel>& channel = link->channel();
  channel->Request<message::OpenInterfaceReply>(message::kOpenInterface, 0, wanted.open,
                                                kAsLongAsTheLink, on_reply);
}

}  // namespace

void PeerLink::Open(const ProcessContext& context, PeerListener& listener,
                    const std::string& process, const std::string& address, Opened opened) {
  constexpr std::chrono::milliseconds kOpenTimeout(800);
  const auto link = std::make_shared<PeerLink>(context.worker, listener);
  ChannelRequest wanted{.opener = context.opener,
                        .address = address,
                        .hello = context.hello,
                        .handler = link,
                        .timeout = kOpenTimeout};
  wanted.hello.wanted = process;
  wanted.hello.session = 0;  // the session is only for the GCM
  OpenChannel(context, wanted,
              [link, process, address, opened = std::move(opened)](const OpenedChannel& channel) {
                if (channel) {
                  link->Begin(*channel);
                  return opened(link);
                }
                const Error& error = channel.error();
                opened(Error{error.code, "process '" + process + "' cannot be reached at " +
                                             address + ": " + error.message});
              });
}

void PeerLink::Begin(const std::shared_ptr<Channel>& channel) {
  channel_ = channel;
  last_heard_.Set(SteadyClock().Now());
  MonitorPeer(worker_, channel_,
              [weak = weak_from_this()](SteadyTime sent, SteadyTime there, SteadyTime arrived) {
                const auto measured = weak.lock();
                if (!measured) return;
                measured->round_trip_.Set(arrived - sent);
                measured->last_heard_.Set(arrived);
                const std::scoped_lock lock(measured->mutex_);
                measured->clock_.Add(sent, there, arrived);
              });
}

void PeerLink::OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                         std::span<const std::byte> body, Responder responder) {
  if (header.type == message::kGetSchemas) return ReplyWithSchemas(body, responder);
  ChannelHandler::OnRequest(channel, header, body, std::move(responder));
}

void PeerLink::OnNotice(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                        std::span<const std::byte> body) {
  if (header.type == message::kRows || header.type == message::kRowsEnded) {
    return OnRows(channel, header, body);
  }
  if (header.type == message::kMirrorTurned) return OnMirrorEnabled(header.handle, body);
  if (header.type == message::kEvents) {
    return ForEachCall(body, [this](std::uint32_t handler, std::span<const std::byte> value) {
      const auto [proxy, offset] = handles_.Find(handler);
      if (proxy && offset > 0) proxy->OnEvent(offset - 1, value);
    });
  }
  const auto [proxy, offset] = handles_.Find(header.handle);
  if (!proxy || offset > 0) return;  // the connection has been closed
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

Result<PeerLink::MirroredValues> PeerLink::MakeCopies(const message::MirrorReply& mirrored) {
  MirroredValues values;
  const std::scoped_lock lock(mutex_);
  EndUnread();
  for (const message::MirroredColumn& column : mirrored.columns) {
    if (column.capacity > StateTable::kMaximumRowBytes) {
      return Error{ErrorCode::kInvalid, channel_->peer().name + " offers a mirrored value of " +
                                            std::to_string(column.capacity) +
                                            " bytes, which is too large"};
    }
    values.push_back(std::make_shared<MirroredValue>(column.capacity));
    if (!column.value.empty()) Put(*values.back(), column.time, column.value);
    if (column.handle != 0) mirrored_[column.handle] = values.back();
  }
  return values;
}

/// Unsubscribes from copies that nobody reads any more. OnRows() does the same, but only when new
/// rows arrive.
void PeerLink::EndUnread() {
  std::erase_if(mirrored_, [this](const auto& one) {
    if (!one.second.expired()) return false;
    (void)channel_->Notify(message::kUnsubscribe, one.first, Bytes());
    return true;
  });
}

void PeerLink::OnRows(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                      std::span<const std::byte> body) {
  const std::scoped_lock lock(mutex_);
  const auto found = mirrored_.find(header.handle);
  const auto value = found == mirrored_.end() ? nullptr : found->second.lock();
  if (!value || header.type == message::kRowsEnded) {
    if (value) value->End();
    if (found != mirrored_.end()) mirrored_.erase(found);
    if (!value) (void)channel->Notify(message::kUnsubscribe, header.handle, Bytes());
    return;
  }
  const auto rows = RowBatchReader::Open(body);
  if (rows && rows->header().rows > 0 && rows->header().columns == 1) {
    const std::size_t newest = rows->header().rows - 1;
    Put(*value, rows->time(newest), rows->cell(newest, 0));
  }
  // The process sends no more rows until this notice arrives.
  NotifyUntilSent(worker_, channel, message::kRowTaken, header.handle);
}

void PeerLink::OnMirrorEnabled(std::uint32_t handle, std::span<const std::byte> body) {
  const auto is_enabled = DecodeBody<bool>(body);
  const std::scoped_lock lock(mutex_);
  const auto found = mirrored_.find(handle);
  const auto value = found == mirrored_.end() ? nullptr : found->second.lock();
  if (value && is_enabled) value->SetEnabled(*is_enabled);
}

void PeerLink::Put(MirroredValue& value, std::int64_t time, std::span<const std::byte> body) {
  const SteadyTime there = ClockOffset::Sensible(SteadyTime(std::chrono::nanoseconds(time)));
  (void)value.Put(there - clock_.SlewedAt(there), body);
}

void PeerLink::OnClosed(const std::shared_ptr<Channel>& /*channel*/, const Error& reason) {
  for (const auto& proxy : handles_.objects()) proxy->Sever();
  worker_->Post(
      [self = shared_from_this(), reason] { self->listener_.OnLinkClosed(*self, reason); });
}

void OpenProvided(const std::shared_ptr<NetworkThread>& network,
                  const std::shared_ptr<PeerLink>& link, const InterfaceRequest& wanted,
                  const Done& done) {
  if (wanted.mirrored.empty()) return Open(network, link, wanted, {}, done);
  link->channel()->Request<message::MirrorReply>(
      message::kMirror, 0, message::Mirror{wanted.open.provided, wanted.mirrored}, kAsLongAsTheLink,
      [network, link, wanted, done](const Result<message::MirrorReply>& reply) {
        if (!reply) return done(reply.error());
        if (reply->columns.size() != wanted.mirrored.size()) {
          return done(Error{
              ErrorCode::kInvalid,
              link->channel()->peer().name + " does not offer the requested mirrored values"});
        }
        const auto copies = link->MakeCopies(*reply);
        if (!copies) return done(copies.error());
        Open(network, link, wanted, *copies, done);
      });
}

}  // namespace tendon
