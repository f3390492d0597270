#include <tendon/process/connections/opening.h>
#include <tendon/proxy/connection_messages.h>

#include <exception>
#include <utility>

namespace tendon {
namespace {

OpenedChannel Open(Middleware& middleware, const ChannelRequest& wanted) {
  try {
    return Channel::Open(middleware, wanted.address, wanted.hello, wanted.handler, wanted.timeout);
  } catch (const std::exception& failure) {  // memory or threads may be exhausted
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

constexpr std::chrono::hours kAsLongAsTheLink(24 * 365);

using Done = std::function<void(const OpenedInterface&)>;

OpenedInterface MakeProxy(const std::shared_ptr<NetworkThread>& network, const PeerLink& link,
                          const Result<message::OpenInterfaceReply>& answer,
                          const InterfaceRequest& wanted, const PeerLink::MirroredValues& copies) {
  if (!answer) return answer.error();
  const std::shared_ptr<Channel>& channel = link.channel();
  ProvidedInterfaceProxy::Remote remote{.channel = channel,
                                        .opened = *answer,
                                        .name = wanted.open.provided,
                                        .mirrored = {},
                                        .line = wanted.line};
  for (std::size_t i = 0; i < copies.size(); ++i) remote.mirrored[wanted.mirrored[i]] = copies[i];
  try {
    return std::make_shared<ProvidedInterfaceProxy>(network, remote, wanted.open.description,
                                                    wanted.read_deadline);
  } catch (const ConfigurationError& error) {
    (void)channel->Notify(message::kCloseInterface, answer->handle, Bytes());
    return Error{ErrorCode::kInvalid,
                 channel->peer().name + " sent an invalid answer: " + error.what()};
  }
}

void Open(const std::shared_ptr<NetworkThread>& network, const std::shared_ptr<PeerLink>& link,
          const InterfaceRequest& wanted, const PeerLink::MirroredValues& copies,
          const Done& done) {
  const auto on_answer = [network, link, wanted, copies,
                          done](const Result<message::OpenInterfaceReply>& answer) {
    const OpenedInterface proxy = MakeProxy(network, *link, answer, wanted, copies);
    if (proxy) link->handles().Put(wanted.open.handle, *proxy);
    done(proxy);
  };
  const std::shared_ptr<Channel>& channel = link->channel();
  channel->Request<message::OpenInterfaceReply>(message::kOpenInterface, 0, wanted.open,
                                                kAsLongAsTheLink, on_answer);
}

}  // namespace

void OpenChannel(const ProcessContext& context, const ChannelRequest& wanted,
                 std::function<void(const OpenedChannel&)> done) {
  wanted.opener->Post(
      [middleware = context.middleware, worker = context.worker, wanted, done = std::move(done)] {
        const auto handoff = std::make_shared<ChannelHandoff>(*middleware, wanted);
        worker->Post([handoff, done] { done(handoff->Take()); });
      });
}

void OpenProvided(const std::shared_ptr<NetworkThread>& network,
                  const std::shared_ptr<PeerLink>& link, const InterfaceRequest& wanted,
                  const Done& done) {
  if (wanted.mirrored.empty()) return Open(network, link, wanted, {}, done);
  link->channel()->Request<message::MirrorReply>(
      message::kMirror, 0, message::Mirror{wanted.open.provided, wanted.mirrored}, kAsLongAsTheLink,
      [network, link, wanted, done](const Result<message::MirrorReply>& answer) {
        if (!answer) return done(answer.error());
        if (answer->columns.size() != wanted.mirrored.size()) {
          return done(
              Error{ErrorCode::kInvalid,
                    link->channel()->peer().name + " offers other mirrored values than requested"});
        }
        const auto copies = link->MakeCopies(*answer);
        if (!copies) return done(copies.error());
        Open(network, link, wanted, *copies, done);
      });
}

}  // namespace tendon
