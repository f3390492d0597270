#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/access/guarded_handler.h>
#include <tendon/process/server/member_calls.h>
#include <tendon/process/server/request_quota.h>
#include <tendon/process/server/served_connections.h>
#include <tendon/process/server/viewer_watch.h>
#include <tendon/process/telemetry/telemetry_server.h>

#include <functional>
#include <memory>
#include <span>
#include <string>

namespace tendon {

/// The services of a process for others.
struct Services {
  ProcessContext& context;
  ServedConnections connections;
  MemberCalls calls;
  TelemetryServer telemetry;
};

/// Serves one channel that another process or a viewer has opened. Executes commands and reads in
/// the middleware's thread; posts all other work, which might block, to the worker.
class PeerSession final : public GuardedHandler {
 public:
  explicit PeerSession(Services& services) : services_(services) {}

 private:
  using SharedChannel = std::shared_ptr<Channel>;
  using Body = std::span<const std::byte>;

  void OnOpen(const SharedChannel& channel, const Hello& peer) override;
  void OnAllowedRequest(const SharedChannel& channel, const FrameHeader& header, Body body,
                        Responder responder) override;
  void OnAllowedNotice(const SharedChannel& channel, const FrameHeader& header, Body body) override;
  [[nodiscard]] std::string ObjectOf(const FrameHeader& header, Body body) const override;
  void OnClosed(const SharedChannel& channel, const Error& reason) override;

  void Call(const FrameHeader& header, Body body, Responder responder);
  void OpenInterface(Body body, Responder responder);
  void Listen(Body body, Responder responder);
  template <typename Wanted>
  void Post(Body body, Responder responder,
            std::function<void(const Wanted&, const std::shared_ptr<Responder>&)> serve);
  void PostNotice(const SharedChannel& channel, std::function<void()> serve);
  void GetCounts(Body body, Responder responder);
  void GetFill(Body body, Responder responder);
  void CallMember(Body body, Responder responder);
  /// Subscribes directly or through a topic, depending on `type`.
  void Subscribe(MessageType type, const SharedChannel& channel, Body body, Responder responder);
  void Mirror(const SharedChannel& channel, Body body, Responder responder);

  Services& services_;
  const std::shared_ptr<Client> client_ = std::make_shared<Client>();
  const std::shared_ptr<ViewerWatch> watch_ =
      std::make_shared<ViewerWatch>(services_.context.worker);
  const std::shared_ptr<RequestQuota> backlog_ = std::make_shared<RequestQuota>();
};

}  // namespace tendon
