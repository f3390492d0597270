#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/connections/member_calls.h>
#include <tendon/process/connections/served_connections.h>
#include <tendon/process/guarded_handler.h>
#include <tendon/process/heartbeat.h>
#include <tendon/process/history/process_history.h>
#include <tendon/process/telemetry/telemetry_server.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace tendon {

/// The services that a process offers to other processes.
struct Services {
  ProcessContext& context;
  ProcessHistory& history;
  ServedConnections connections;
  MemberCalls calls;
  TelemetryServer telemetry;
};

/// Limits how many requests of one peer wait for a thread. Without the limit, a peer that sends
/// faster than it is served could use up the memory. Thread-safe.
class RequestQuota : public std::enable_shared_from_this<RequestQuota> {
 public:
  /// Maximum number of waiting requests: four times the subscriptions that a viewer may have.
  static constexpr std::size_t kMaxTasks = 8192;
  /// Maximum size of all waiting messages together, in bytes. It also limits a single message.
  static constexpr std::size_t kMaxBytes = std::size_t{8} << 20U;

  /// Counts one waiting request while it exists.
  class Reservation {
   public:
    Reservation(std::shared_ptr<RequestQuota> quota, std::size_t bytes)
        : quota_(std::move(quota)), bytes_(bytes) {}
    Reservation(const Reservation&) = delete;
    Reservation& operator=(const Reservation&) = delete;
    ~Reservation() { quota_->Release(bytes_); }

   private:
    const std::shared_ptr<RequestQuota> quota_;
    const std::size_t bytes_;
  };

  /// Reserves room for one request. Returns null if the request would exceed the limits.
  [[nodiscard]] std::shared_ptr<Reservation> Reserve(std::size_t bytes);

 private:
  void Release(std::size_t bytes);

  std::mutex mutex_;
  std::size_t tasks_ = 0;
  std::size_t bytes_ = 0;
};

/// Serves one channel that another process or a viewer has opened. Executes commands and reads in
/// the middleware's thread. Posts all work that might block to the worker.
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
  void ReadRows(Body body, Responder responder);
  void ReadEvents(Body body, Responder responder);
  void ReadLog(Body body, Responder responder);
  void GetProcessHistory(Body body, Responder responder);
  void Mirror(const SharedChannel& channel, Body body, Responder responder);

  Services& services_;
  const std::shared_ptr<Client> client_ = std::make_shared<Client>();
  const std::shared_ptr<ViewerMonitor> monitor_ =
      std::make_shared<ViewerMonitor>(services_.context.worker);
  const std::shared_ptr<RequestQuota> quota_ = std::make_shared<RequestQuota>();
};

}  // namespace tendon
