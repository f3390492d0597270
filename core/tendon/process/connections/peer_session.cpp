#include <tendon/process/connections/peer_session.h>

#include <tendon/process/heartbeat.h>
#include <tendon/process/schema_exchange.h>
#include <tendon/process/version_messages.h>

#include <utility>

namespace tendon {
namespace {

message::Pong PongOfNow() { return {.time = SteadyClock().Now().time_since_epoch().count()}; }

}  // namespace

void PeerSession::OnOpen(const SharedChannel& channel, const Hello& /*peer*/) {
  client_->channel = channel;
  KeepExpiring(*services_.context.worker, channel);
}

void PeerSession::OnAllowedRequest(const SharedChannel& channel, const FrameHeader& header,
                                   Body body, Responder responder) {
  const MessageType type = header.type;
  if (type == message::kRead || type == message::kWait) {
    return Call(header, body, std::move(responder));
  }
  if (type == message::kPing) {
    monitor_->OnPing();
    return responder.Reply(EncodeBody(PongOfNow()), kOwnLane);
  }
  if (type == message::kOpenInterface) return OpenInterface(body, std::move(responder));
  if (type == message::kListen) return Listen(body, std::move(responder));
  if (type == message::kGetSchemas) return ReplyWithSchemas(body, responder);
  if (type == message::kGetCounts) return GetCounts(body, std::move(responder));
  if (type == message::kGetFill) return GetFill(body, std::move(responder));
  if (type == message::kGetProgram) return responder.ReplyWith(Result(OwnVersion()));
  if (type == message::kCallMember) return CallMember(body, std::move(responder));
  if (type == message::kSubscribe || type == message::kJoinTopic) {
    return Subscribe(type, channel, body, std::move(responder));
  }
  if (type == message::kReadRows) return ReadRows(body, std::move(responder));
  if (type == message::kReadEvents) return ReadEvents(body, std::move(responder));
  if (type == message::kReadLog) return ReadLog(body, std::move(responder));
  if (type == message::kGetProcessHistory) return GetProcessHistory(body, std::move(responder));
  if (type == message::kMirror) return Mirror(channel, body, std::move(responder));
  ChannelHandler::OnRequest(channel, header, body, std::move(responder));
}

void PeerSession::OnAllowedNotice(const SharedChannel& channel, const FrameHeader& header,
                                  Body body) {
  const std::uint32_t handle = header.handle;
  if (header.type == message::kCommands) {
    ForEachCall(body, [this](std::uint32_t function, Body argument) {
      const auto [proxy, offset] = client_->handles.Find(function);
      if (proxy && offset > 0) proxy->OnCommand(offset - 1, argument);
    });
  } else if (header.type == message::kEventsLost) {
    const auto [proxy, offset] = client_->handles.Find(handle);
    const auto events = DecodeBody<message::EventsLost>(body);
    if (proxy && offset == 0 && events) proxy->OnEventsLost(*events);
  } else if (header.type == message::kCloseInterface) {
    PostNotice(channel, [&services = services_, client = client_, handle] {
      services.connections.Close(client, handle);
    });
  } else if (header.type == message::kUnsubscribe) {
    const auto reservation = quota_->Reserve(0);
    if (!reservation) return;  // if the viewer still gets rows, it unsubscribes again
    services_.context.worker->Post([reservation, &services = services_, channel, handle] {
      services.telemetry.Unsubscribe(channel, handle);
    });
  } else if (header.type == message::kRowTaken) {
    services_.telemetry.OnRowTaken(channel, handle);
  }
}

std::string PeerSession::ObjectOf(const FrameHeader& header, Body body) const {
  if (header.type == message::kCallMember) {
    const auto call = DecodeBody<message::CallMember>(body);
    return call ? call->component + "/" + call->interface + "." + call->member : std::string();
  }
  if (header.type == message::kOpenInterface) {
    const auto open = DecodeBody<message::OpenInterface>(body);
    return open ? EndsOf(*open) : std::string();
  }
  return {};
}

void PeerSession::OnClosed(const SharedChannel& /*channel*/, const Error& /*reason*/) {
  for (const auto& proxy : client_->handles.objects()) proxy->Sever();
  services_.context.worker->Post(
      [&services = services_, client = client_] { services.connections.CloseAll(client); });
}

void PeerSession::Call(const FrameHeader& header, Body body, Responder responder) {
  const auto [proxy, offset] = client_->handles.Find(header.handle);
  if (!proxy || offset == 0) {
    return responder.Refuse({ErrorCode::kNotFound, "the connection was closed"});
  }
  if (header.type == message::kRead) {
    proxy->OnRead(offset - 1, body, std::move(responder));
  } else {
    proxy->OnWait(offset - 1, body, std::move(responder));
  }
}

void PeerSession::OpenInterface(Body body, Responder responder) {
  Post<message::OpenInterface>(
      body, std::move(responder),
      [&services = services_, client = client_](const auto& open, const auto& kept) {
        services.connections.Open(client, open, ServedConnections::Use::kAll, kept);
      });
}

/// Serves a client that only listens to events. The client may be a viewer, which must not call
/// functions. The client gets all events with their times.
void PeerSession::Listen(Body body, Responder responder) {
  Post<message::OpenInterface>(
      body, std::move(responder),
      [&services = services_, client = client_](const auto& open, const auto& kept) {
        if (!open.description.functions.empty()) {
          return kept->Refuse({ErrorCode::kInvalid, "the request to listen to the events of " +
                                                        ToString(open.provided) +
                                                        " must not contain functions"});
        }
        message::OpenInterface all = open;
        all.latest_only.clear();
        services.connections.Open(client, all, ServedConnections::Use::kEventsOnly, kept);
      });
}

/// Serves a request on the worker, because the request may have to wait for a lock.
/// Reserves room in the quota before it decodes the request, because decoding needs more memory.
template <typename Wanted>
void PeerSession::Post(
    Body body, Responder responder,
    std::function<void(const Wanted&, const std::shared_ptr<Responder>&)> serve) {
  const auto reservation = quota_->Reserve(body.size());
  if (!reservation) {
    return responder.Refuse(
        {ErrorCode::kFailed,
         "process '" + services_.context.name + "' keeps at most " +
             std::to_string(RequestQuota::kMaxTasks) +
             " waiting requests of one peer, with at most " +
             std::to_string(RequestQuota::kMaxBytes) +
             " bytes in total: send fewer requests at once, or wait for replies"});
  }
  auto wanted = DecodeBody<Wanted>(body);
  if (!wanted) return responder.Refuse(wanted.error());
  services_.context.worker->Post([reservation, serve = std::move(serve),
                                  wanted = *std::move(wanted),
                                  responder = std::make_shared<Responder>(std::move(responder))] {
    serve(wanted, responder);
  });
}

/// Serves a notice on the worker. A notice cannot be refused, so the channel is closed if the quota
/// is used up.
void PeerSession::PostNotice(const SharedChannel& channel, std::function<void()> serve) {
  const auto reservation = quota_->Reserve(0);
  if (!reservation) return channel->CutOff("sends more than this process can handle");
  services_.context.worker->Post([reservation, serve = std::move(serve)] { serve(); });
}

void PeerSession::GetCounts(Body body, Responder responder) {
  Post<message::GetCounts>(
      body, std::move(responder),
      [&process = services_.context.process](const auto& asked, const auto& kept) {
        kept->ReplyWith(process.LookUpCounts(asked.required));
      });
}

void PeerSession::GetFill(Body body, Responder responder) {
  Post<message::GetFill>(
      body, std::move(responder),
      [&process = services_.context.process](const auto& asked, const auto& kept) {
        kept->ReplyWith(process.LookUpFill(asked.component));
      });
}

void PeerSession::CallMember(Body body, Responder responder) {
  auto call = DecodeBody<message::CallMember>(body);
  if (!call) return responder.Refuse(call.error());
  services_.calls.Call(std::make_shared<message::CallMember>(*std::move(call)),
                       std::make_shared<Responder>(std::move(responder)));
}

void PeerSession::Subscribe(MessageType type, const SharedChannel& channel, Body body,
                            Responder responder) {
  monitor_->Begin(channel);
  Post<message::Subscribe>(
      body, std::move(responder),
      [&telemetry = services_.telemetry, type, channel](const auto& wanted, const auto& kept) {
        if (type == message::kJoinTopic) return telemetry.JoinTopic(channel, wanted, *kept);
        telemetry.Subscribe(channel, wanted, *kept);
      });
}

void PeerSession::ReadRows(Body body, Responder responder) {
  Post<message::ReadRows>(body, std::move(responder),
                          [&telemetry = services_.telemetry](const auto& wanted, const auto& kept) {
                            telemetry.ReadRows(wanted, *kept);
                          });
}

void PeerSession::ReadEvents(Body body, Responder responder) {
  Post<message::ReadEvents>(body, std::move(responder),
                            [&history = services_.history](const auto& wanted, const auto& kept) {
                              kept->ReplyWith(history.ReadEvents(wanted));
                            });
}

void PeerSession::ReadLog(Body body, Responder responder) {
  Post<message::ReadLog>(body, std::move(responder),
                         [&history = services_.history](const auto& wanted, const auto& kept) {
                           kept->ReplyWith(history.ReadLog(wanted));
                         });
}

void PeerSession::GetProcessHistory(Body body, Responder responder) {
  Post<None>(body, std::move(responder),
             [&history = services_.history](const auto& /*wanted*/, const auto& kept) {
               kept->ReplyWith(Result(history.state()));
             });
}

void PeerSession::Mirror(const SharedChannel& channel, Body body, Responder responder) {
  Post<message::Mirror>(
      body, std::move(responder),
      [&telemetry = services_.telemetry, channel](const auto& wanted, const auto& kept) {
        telemetry.Mirror(channel, wanted, *kept);
      });
}

std::shared_ptr<RequestQuota::Reservation> RequestQuota::Reserve(std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  if (tasks_ == kMaxTasks || bytes > kMaxBytes - bytes_) return nullptr;
  auto reservation = std::make_shared<Reservation>(shared_from_this(), bytes);
  ++tasks_;
  bytes_ += bytes;
  return reservation;
}

void RequestQuota::Release(std::size_t bytes) {
  const std::scoped_lock lock(mutex_);
  --tasks_;
  bytes_ -= bytes;
}

}  // namespace tendon
