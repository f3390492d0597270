#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/rate_limited_warning.h>
#include <tendon/gcm/lifecycle/lifecycle_orders.h>
#include <tendon/gcm/members/deferred_actions.h>
#include <tendon/gcm/members/registry.h>
#include <tendon/gcm/server/connection_orders.h>
#include <tendon/gcm/server/log_buffer.h>
#include <tendon/gcm/server/watchers.h>
#include <tendon/gcm/supervisor/supervisor.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/audit_log.h>
#include <tendon/process/log/log_queue.h>
#include <tendon/process/log/scoped_log_sink.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tendon::server {

/// The GCM's server for the channels of LCMs and viewers. One mutex protects the state. Code that
/// holds the mutex only makes decisions; deferred actions later send, reply and log. The history
/// writes its file in its own thread. Thread-safe.
class Server final : public std::enable_shared_from_this<Server> {
 public:
  struct Options {
    std::filesystem::path history;
    Leases leases;
    const Clock* clock = nullptr;
    std::chrono::milliseconds order_timeout;
    std::uint64_t instance = 0;
    std::shared_ptr<Launcher> launcher{};
    std::string broker{};  ///< the broker's address; empty without a broker
  };
  explicit Server(Options options);

  /// Must be called once, before all other functions.
  void Start();
  /// Ends the server's threads and waits until the history is on the disk. After this, no request
  /// is answered.
  void Stop();

  /// Returns a new handler for one channel.
  std::shared_ptr<ChannelHandler> MakeHandler();
  [[nodiscard]] Catalogue catalogue() const;
  void Tick();

 private:
  class Peer;
  using SharedChannel = std::shared_ptr<Channel>;
  /// The viewer that has the plan lock. The lock is released at the latest when the viewer's
  /// channel closes.
  struct PlanLockHolder {
    const Peer* peer = nullptr;
    std::string who;
    std::int64_t since = 0;  ///< ns since 1970
  };
  struct Request {
    Peer& peer;
    SharedChannel channel;
    std::span<const std::byte> body;
    std::shared_ptr<Responder> responder;  ///< shared, because std::function must be copyable
  };

  /// Calls `action` and publishes its changes of the catalogue, both while the lock is held. Then
  /// releases the lock and runs the deferred actions.
  template <typename Action>
  void Locked(Action&& action);
  template <typename Part>
  auto LockedWith(std::unique_ptr<Part> Server::*part);
  void Publish();
  void ReportPeers();
  void SendPeers();
  void KeepTicking();
  void WriteOwnLog();

  /// Returns the name of the peer in printable form.
  static std::string NameOf(const Channel& channel);

  /// The type of a function that serves one type of request. The functions follow below.
  using Serve = void (Server::*)(const Request&);
  static Serve ServeOf(MessageType type);
  void Join(const Request& request);
  void Renew(const Request& request);
  void OnHealth(const Request& request);
  void Leave(const Request& request);
  void Watch(const Request& request);
  void Connect(const Request& request);
  void Replace(const Request& request);
  void Disconnect(const Request& request);
  void ExecuteLifecycleOrder(const Request& request);
  void ExecuteProcessOrder(const Request& request);
  void ListClasses(const Request& request);
  void BeginOrder(const Request& request);
  void Undo(const Request& request);
  void SkipNewestStep(const Request& request);
  void TakePlanLock(const Request& request);
  void ReportHistory(const Request& request);
  void ReportHealth(const Request& request);
  void ReportBroker(const Request& request);
  void ReportVersion(const Request& request);
  void ReportChildren(const Request& request);
  void Forget(const Request& request);
  void WatchLog(const Request& request);
  void SetLogLevel(const Request& request);
  void ConnectInterface(const Request& request, WhenConnected when_connected);
  void OnReport(const Peer& peer, std::span<const std::byte> body);
  /// `session` is a reference, because its value may be read only while the lock is held.
  void OnLogRecords(const SessionToken& session, std::span<const std::byte> body);
  void OnClosed(Peer& peer, const SharedChannel& channel, const Error& reason);

  /// Adds a deferred action that sends the reply. Called while the lock is held.
  template <typename T>
  void Reply(const Request& request, Result<T> result);

  const Options options_;
  StepHistory history_;
  RateLimitedWarning malformed_{"gcm"};
  DeferredActions deferred_;
  Watchers watchers_;     // used only by deferred actions
  LogBuffer log_buffer_;  // used only by deferred actions
  AuditLog audit_;
  LogQueue own_log_;
  mutable std::mutex mutex_;
  Registry registry_;
  std::unique_ptr<LifecycleOrders> lifecycle_orders_;
  std::unique_ptr<Supervisor> supervisor_;
  std::unique_ptr<ConnectionOrders> connection_orders_;
  PlanLockHolder plan_lock_;
  bool stopped_ = false;
  bool are_peers_due_ = false;
  SteadyTime peers_sent_at_{};
  Worker worker_{"gcm"};
  ScopedLogSink own_log_sink_{[this](LogLevel level, std::string_view source,
                                     std::string_view text) { own_log_.Add(level, source, text); }};
};

template <typename Action>
void Server::Locked(Action&& action) {
  {
    const std::scoped_lock lock(mutex_);
    if (stopped_) return;
    action();
    Publish();
  }
  deferred_.Flush();
}

template <typename T>
void Server::Reply(const Request& request, Result<T> result) {
  deferred_.Add([responder = request.responder, result = std::move(result)] {
    responder->ReplyWith(result);
  });
}

}  // namespace tendon::server
