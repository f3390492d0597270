#include <tendon/gcm/server/server.h>

#include <tendon/base/log.h>
#include <tendon/base/os/process.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/members/sanitize.h>
#include <tendon/gcm/text.h>
#include <tendon/middleware/hello.h>
#include <tendon/process/ask.h>
#include <tendon/process/broadcast_messages.h>
#include <tendon/process/guarded_handler.h>
#include <tendon/process/heartbeat.h>
#include <tendon/process/version_messages.h>

#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace tendon::server {
namespace {

constexpr std::chrono::milliseconds kTick(100);

/// Returns a function that sends a result of any type as the reply.
auto ReplyThrough(const std::shared_ptr<Responder>& responder) {
  return [responder](const auto& result) { responder->ReplyWith(result); };
}

/// Returns true if the process is this program. A window that hosts a GCM is also a process. Log
/// records of this program are already in the buffer.
bool IsOwn(const ProcessDescription& process) {
  return process.name == kGcmName && process.pid == os::ProcessId() &&
         process.host == os::HostName();
}

std::string_view Words(ProcessState state) {
  switch (state) {
    case ProcessState::kAlive:
      return "is available";
    case ProcessState::kSuspect:
      return "is suspect";
    case ProcessState::kLost:
      return "is lost";
    case ProcessState::kLeft:
      return "has left";
    case ProcessState::kStarting:
      return "is starting";
  }
  return "?";
}

/// Logs each change of the state of a process.
void LogProcesses(const std::vector<CatalogueChange>& changes) {
  for (const CatalogueChange& change : changes) {
    if (change.kind != CatalogueChange::Kind::kProcess) continue;
    const ProcessDescription& process = change.processes.front();
    const bool is_gone =
        process.state == ProcessState::kSuspect || process.state == ProcessState::kLost;
    const bool is_hidden = process.state == ProcessState::kAlive && !process.reason.empty();
    const bool well = !is_gone && !is_hidden;
    const std::string reason = process.reason.empty() ? "" : ": " + process.reason;
    Log(well ? LogLevel::kInfo : LogLevel::kWarning, "gcm",
        "process '" + process.name + "' " + std::string(Words(process.state)) + reason);
  }
}

bool ChangesProcesses(const std::vector<CatalogueChange>& changes) {
  return std::ranges::any_of(changes, [](const CatalogueChange& change) {
    return change.kind == CatalogueChange::Kind::kProcess;
  });
}

}  // namespace

/// The handler of one channel, of an LCM or a viewer.
class Server::Peer final : public GuardedHandler {
 public:
  explicit Peer(std::shared_ptr<Server> server) : server_(std::move(server)) {}

  void OnOpen(const std::shared_ptr<Channel>& channel, const Hello& /*peer*/) override {
    KeepExpiring(server_->worker_, channel);
  }

  void OnAllowedRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                        std::span<const std::byte> body, Responder responder) override {
    if (const Serve serve = ServeOf(header.type)) {
      const auto shared = std::make_shared<Responder>(std::move(responder));
      return ((*server_).*serve)({*this, channel, body, shared});
    }
    responder.Refuse({ErrorCode::kInvalid, "the GCM does not know messages of type " +
                                               std::to_string(static_cast<unsigned>(header.type))});
  }

  void OnAllowedNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                       std::span<const std::byte> body) override {
    if (header.type == message::kReport) server_->OnReport(*this, body);
    if (header.type == message::kLogRecords) server_->OnLogRecords(session, body);
  }

  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override {
    server_->OnClosed(*this, channel, reason);
  }

  [[nodiscard]] std::string ObjectOf(const FrameHeader& header,
                                     std::span<const std::byte> body) const override {
    return AuditObject(header.type, body);
  }

  SessionToken session = 0;  // guarded by the server's lock; 0: not a member

 private:
  const std::shared_ptr<Server> server_;
};

std::string Server::NameOf(const Channel& channel) { return Printable(channel.peer().name, 64); }

Server::Server(Options options)
    : options_(std::move(options)),
      history_(options_.history),
      registry_(options_.leases, *options_.clock) {}

/// Returns the Locked function for the constructor of `part`, for example the Supervisor.
template <typename Part>
auto Server::LockedWith(std::unique_ptr<Part> Server::*part) {
  return [weak = weak_from_this(), part](const std::function<void(Part&)>& action) {
    if (const auto self = weak.lock()) self->Locked([&] { action(*((*self).*part)); });
  };
}

void Server::Start() {
  lifecycle_orders_ = std::make_unique<LifecycleOrders>(
      LifecycleOrders::Parts{registry_, history_, deferred_, worker_},
      LockedWith(&Server::lifecycle_orders_), options_.order_timeout);
  supervisor_ = std::make_unique<Supervisor>(
      Supervisor::Parts{registry_, history_, deferred_, *options_.clock, options_.launcher},
      LockedWith(&Server::supervisor_));
  connection_orders_ = std::make_unique<ConnectionOrders>(
      ConnectionOrders::Parts{registry_, history_, deferred_, worker_, *lifecycle_orders_,
                              *supervisor_},
      LockedWith(&Server::connection_orders_), options_.order_timeout);
  KeepTicking();
}

void Server::Stop() {
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
  }
  worker_.Stop();
  supervisor_->Stop();
  history_.Close();
}

std::shared_ptr<ChannelHandler> Server::MakeHandler() {
  return std::make_shared<Peer>(shared_from_this());
}

Catalogue Server::catalogue() const {
  const std::scoped_lock lock(mutex_);
  return registry_.catalogue();
}

void Server::Tick() {
  Locked([this] {
    for (const auto& channel : registry_.Tick()) {
      deferred_.Add([channel] { channel->Close(); });
    }
    supervisor_->Tick();
    if (std::exchange(are_peers_due_, false)) SendPeers();
    deferred_.Add([this] {
      watchers_.Pump();
      WriteOwnLog();
    });
  });
}

void Server::KeepTicking() {
  Tick();
  worker_.PostAfter(kTick, [this] { KeepTicking(); });
}

void Server::Publish() {
  if (auto changes = registry_.TakeChanges(); !changes.empty()) {
    if (ChangesProcesses(changes)) ReportPeers();
    deferred_.Add([this, changes = std::move(changes)] {
      watchers_.Publish(changes);
      LogProcesses(changes);
      for (const CatalogueChange& change : changes) {
        if (change.kind == CatalogueChange::Kind::kProcessRemoved)
          log_buffer_.Forget(change.process);
      }
    });
  }
  for (const message::ConnectionEnds& ends : registry_.TakeDueConnections()) {
    connection_orders_->RestoreConnection(ends);
  }
}

/// Sends the list of processes at once, but at most once per tick. Without this limit, many
/// processes that join together would be too busy to renew their leases.
void Server::ReportPeers() {
  if (SteadyClock().Now() - peers_sent_at_ < kTick) {
    are_peers_due_ = true;
  } else {
    SendPeers();
  }
}

void Server::SendPeers() {
  peers_sent_at_ = SteadyClock().Now();
  const auto body = std::make_shared<const Bytes>(EncodeBody(registry_.peers()));
  for (const auto& channel : registry_.channels()) {
    deferred_.Add([this, channel, body] {
      const Status status = channel->Notify(message::kPeers, 0, *body);
      if (status.code() != Status::kQueueFull) return;
      const std::scoped_lock lock(mutex_);
      are_peers_due_ = true;
    });
  }
}

Server::Serve Server::ServeOf(MessageType type) {
  static const std::map<MessageType, Serve> kServes = {
      {message::kJoin, &Server::Join},
      {message::kRenew, &Server::Renew},
      {message::kLeave, &Server::Leave},
      {message::kWatch, &Server::Watch},
      {message::kConnect, &Server::Connect},
      {message::kDisconnect, &Server::Disconnect},
      {message::kUndo, &Server::Undo},
      {message::kHistory, &Server::ReportHistory},
      {message::kForget, &Server::Forget},
      {message::kReplace, &Server::Replace},
      {message::kWatchLog, &Server::WatchLog},
      {message::kSetLogLevel, &Server::SetLogLevel},
      {message::kLifecycleOrder, &Server::ExecuteLifecycleOrder},
      {message::kGetClasses, &Server::ListClasses},
      {message::kSkipStep, &Server::SkipNewestStep},
      {message::kPlanLock, &Server::TakePlanLock},
      {message::kBeginOrder, &Server::BeginOrder},
      {message::kHealth, &Server::ReportHealth},
      {message::kReportHealth, &Server::OnHealth},
      {message::kGetBroker, &Server::ReportBroker},
      {message::kProcess, &Server::ExecuteProcessOrder},
      {message::kGetProgram, &Server::ReportVersion},
      {message::kGetChildren, &Server::ReportChildren}};
  const auto found = kServes.find(type);
  return found == kServes.end() ? nullptr : found->second;
}

void Server::Join(const Request& request) {
  auto join = DecodeBody<message::Join>(request.body);
  if (!join) return request.responder->Refuse(join.error());
  const std::string peer = NameOf(*request.channel);
  const std::string who = NameAndRole(*request.channel, request.channel->peer().role);
  if (const std::string name = Printable(join->process.name, 64); peer != name) {
    audit_.Write(peer, LogLevel::kWarning, who + ": join as '" + name + "': refused");
    return request.responder->Refuse(
        {ErrorCode::kDenied, "'" + peer + "' cannot join as process '" + name +
                                 "': with TLS, the certificate of a process must have the name of "
                                 "the process (gcm cert issue " +
                                 name + " --role operator --process)"});
  }
  Locked([&] {
    SessionToken& session = request.peer.session;
    if (session != 0) {
      return Reply<message::JoinReply>(
          request, Error{ErrorCode::kInvalid, "this channel has already joined"});
    }
    auto admission =
        registry_.Join(*std::move(join), request.channel->peer().session, request.channel);
    if (!admission) {
      audit_.Write(peer, LogLevel::kWarning,
                   who + ": join: refused: " + Printable(admission.error().message, 256));
      return Reply<message::JoinReply>(request, admission.error());
    }
    audit_.Write(peer, LogLevel::kInfo, who + ": join: allowed");
    session = admission->session;
    if (admission->replaced) deferred_.Add([old = admission->replaced] { old->Close(); });
    Reply(request, Result(message::JoinReply{.gcm_instance = options_.instance,
                                             .session = session,
                                             .processes = registry_.peers().processes}));
  });
}

/// Renews the lease of a member. For a viewer, the request is only a ping. The reply has its own
/// lane, so that it does not wait behind a large reply.
void Server::Renew(const Request& request) {
  Locked([&] {
    const SessionToken session = request.peer.session;
    const auto renewed = session == 0 ? Result<void>() : registry_.Renew(session);
    if (!renewed) return Reply(request, renewed);
    deferred_.Add(
        [responder = request.responder] { responder->Reply(EncodeBody(None{}), kOwnLane); });
  });
}

/// Stores the health of a member and replies with the GCM's time. The reply must not wait behind
/// other replies, because it contains the time.
void Server::OnHealth(const Request& request) {
  const message::GcmClock now{SteadyClock().Now().time_since_epoch().count()};
  const auto health = DecodeBody<message::Health>(request.body);
  if (!health) return request.responder->Refuse(health.error());
  Locked([&] {
    const auto taken = registry_.UpdateHealth(request.peer.session, *health);
    if (!taken) return Reply(request, taken);
    deferred_.Add(
        [responder = request.responder, now] { responder->Reply(EncodeBody(now), kOwnLane); });
  });
}

void Server::Leave(const Request& request) {
  Locked([&] {
    registry_.End(std::exchange(request.peer.session, 0), ProcessState::kLeft, "deregistered");
    Reply(request, Result<void>());
  });
}

void Server::Watch(const Request& request) {
  Locked([&] {
    const Catalogue& catalogue = registry_.catalogue();
    message::CatalogueSnapshot snapshot{.gcm_instance = options_.instance,
                                        .changes = catalogue.AsChanges()};
    snapshot.base = catalogue.revision() - snapshot.changes.size();
    Reply(request, Result(std::move(snapshot)));
    deferred_.Add([this, channel = request.channel, revision = catalogue.revision()] {
      if (channel->is_open()) watchers_.Add(channel, revision);
    });
  });
}

void Server::Connect(const Request& request) { ConnectInterface(request, WhenConnected::kRefuse); }

void Server::Replace(const Request& request) { ConnectInterface(request, WhenConnected::kReplace); }

void Server::ConnectInterface(const Request& request, WhenConnected when_connected) {
  const auto ends = DecodeBody<message::ConnectionEnds>(request.body);
  if (!ends) return request.responder->Refuse(ends.error());
  Locked([&] {
    connection_orders_->Connect(*ends, when_connected, NameOf(*request.channel),
                                ReplyThrough(request.responder));
  });
}

void Server::Disconnect(const Request& request) {
  const auto ends = DecodeBody<message::ConnectionEnds>(request.body);
  if (!ends) return request.responder->Refuse(ends.error());
  Locked([&] {
    connection_orders_->Disconnect(ends->required, NameOf(*request.channel),
                                   ReplyThrough(request.responder));
  });
}

void Server::ExecuteLifecycleOrder(const Request& request) {
  const auto order = DecodeBody<message::LifecycleOrder>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] {
    supervisor_->NoteChange(order->process);
    lifecycle_orders_->ExecuteOrder(*order, NameOf(*request.channel),
                                    ReplyThrough(request.responder));
  });
}

void Server::ExecuteProcessOrder(const Request& request) {
  const auto order = DecodeBody<message::ProcessOrder>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] {
    supervisor_->ExecuteOrder(*order, NameOf(*request.channel), ReplyThrough(request.responder));
  });
}

void Server::ListClasses(const Request& request) {
  const auto wanted = DecodeBody<message::GetClasses>(request.body);
  if (!wanted) return request.responder->Refuse(wanted.error());
  Locked([&] { lifecycle_orders_->ListClasses(wanted->process, ReplyThrough(request.responder)); });
}

void Server::BeginOrder(const Request& request) {
  const auto order = DecodeBody<message::BeginOrder>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] {
    const ProcessDescription* const member = registry_.FindMember(request.peer.session);
    const std::string name = member == nullptr ? "" : member->name;
    supervisor_->NoteChange(name);
    Reply(request, lifecycle_orders_->Begin(order->id, name));
  });
}

void Server::Undo(const Request& request) {
  const auto which = DecodeBody<message::StepSelection>(request.body);
  if (!which) return request.responder->Refuse(which.error());
  Locked([&] {
    connection_orders_->Undo(*which, NameOf(*request.channel), ReplyThrough(request.responder));
  });
}

void Server::SkipNewestStep(const Request& request) {
  const auto which = DecodeBody<message::StepSelection>(request.body);
  if (!which) return request.responder->Refuse(which.error());
  Locked([&] {
    connection_orders_->SkipNewestStep(*which, NameOf(*request.channel),
                                       ReplyThrough(request.responder));
  });
}

void Server::TakePlanLock(const Request& request) {
  const auto wanted = DecodeBody<message::PlanLock>(request.body);
  if (!wanted) return request.responder->Refuse(wanted.error());
  Locked([&] {
    const bool is_free = plan_lock_.peer == nullptr || plan_lock_.peer == &request.peer;
    if (is_free && !wanted->is_wanted) plan_lock_ = {};
    if (is_free && wanted->is_wanted && plan_lock_.peer == nullptr) {
      plan_lock_ = {&request.peer, NameOf(*request.channel), WallTime()};
    }
    const bool is_granted = is_free || !wanted->is_wanted;
    Reply(request, is_granted
                       ? Result<void>()
                       : Error{ErrorCode::kFailed, "nothing was done, because a plan of " +
                                                       plan_lock_.who + " has been running since " +
                                                       WallTimeText(plan_lock_.since) +
                                                       "; try again when that plan is done"});
  });
}

void Server::ReportHistory(const Request& request) {
  request.responder->ReplyWith(Result(history_.steps()));
}

void Server::ReportBroker(const Request& request) {
  request.responder->ReplyWith(Result(message::BrokerAddress{options_.broker}));
}

void Server::ReportVersion(const Request& request) {
  request.responder->ReplyWith(Result(OwnVersion()));
}

void Server::ReportChildren(const Request& request) {
  Locked([&] { Reply(request, Result(supervisor_->children())); });
}

void Server::ReportHealth(const Request& request) {
  Locked([&] { Reply(request, Result(registry_.health())); });
}

void Server::Forget(const Request& request) {
  const auto forget = DecodeBody<message::ForgetProcess>(request.body);
  if (!forget) return request.responder->Refuse(forget.error());
  Locked([&] { Reply(request, registry_.Forget(forget->process)); });
}

void Server::OnReport(const Peer& peer, std::span<const std::byte> body) {
  auto report = DecodeBody<message::Report>(body);
  Locked([&] {
    const auto reported =
        report ? registry_.Report(peer.session, *std::move(report)) : Result<void>(report.error());
    if (reported) return;
    deferred_.Add([this, text = reported.error().message] {
      malformed_.Add("a report was not understood: " + text);
    });
  });
}

void Server::OnClosed(Peer& peer, const SharedChannel& channel, const Error& reason) {
  Locked([&] {
    if (plan_lock_.peer == &peer) plan_lock_ = {};
    registry_.End(std::exchange(peer.session, 0), ProcessState::kLost,
                  "its connection broke: " + Printable(reason.message, 256));
    deferred_.Add([this, key = channel.get()] {
      watchers_.Remove(key);
      log_buffer_.Remove(key);
    });
  });
}

/// Adds the log records of this program to the buffer, and sends new records to all watchers. Runs
/// as a deferred action.
void Server::WriteOwnLog() {
  auto records = own_log_.Take(LogQueue::kCapacity, SteadyClock().Now());
  for (message::LogRecord& record : records) log_buffer_.AddOwn(std::move(record));
  log_buffer_.PumpAll();
}

void Server::WatchLog(const Request& request) {
  const auto watch = DecodeBody<message::WatchLog>(request.body);
  if (!watch) return request.responder->Refuse(watch.error());
  const bool goes_on = watch->gcm_instance == options_.instance;
  Locked([&] {
    deferred_.Add([this, channel = request.channel, responder = request.responder,
                   after = goes_on ? watch->after : 0] {
      if (!channel->is_open()) return;
      message::WatchLogReply watched = log_buffer_.Watch(channel, after);
      watched.gcm_instance = options_.instance;
      responder->ReplyWith(Result(watched));
      log_buffer_.Pump();
    });
  });
}

void Server::SetLogLevel(const Request& request) {
  const auto order = DecodeBody<message::SetLogLevel>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] {
    const auto entry = LookUpProcess(registry_.catalogue(), order->process);
    if (!entry) return Reply<None>(request, entry.error());
    const auto present = RequirePresent((*entry)->process);
    if (!present) return Reply(request, present);
    deferred_.Add([this, channel = registry_.ChannelOf(order->process), order = *order,
                   who = NameOf(*request.channel), responder = request.responder] {
      Ask<None>(worker_, channel, message::kSetLogLevel, order, options_.order_timeout,
                [order, who, responder](const auto& done) {
                  if (done) {
                    Log(LogLevel::kInfo, "gcm",
                        who + " has set the log level of process '" + order.process + "' to " +
                            std::string(ToString(order.level)));
                  }
                  responder->ReplyWith(done);
                });
    });
  });
}

void Server::OnLogRecords(const SessionToken& session, std::span<const std::byte> body) {
  if (body.size() > message::kLargestLogBatch) return;
  auto batch = DecodeBody<message::LogRecords>(body);
  if (!batch) return malformed_.Add("records were not understood: " + batch.error().message);
  Sanitize(*batch);
  Locked([&] {
    const ProcessDescription* process = registry_.FindMember(session);
    if (process == nullptr || IsOwn(*process)) return;
    deferred_.Add([this, name = process->name, instance = process->instance,
                   records = *std::move(batch)]() mutable {
      log_buffer_.Add(name, instance, std::move(records));
      log_buffer_.Pump();
    });
  });
}

}  // namespace tendon::server
