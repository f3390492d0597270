#include <tendon/base/log.h>
#include <tendon/base/text.h>
#include <tendon/gcm/server/process_news.h>
#include <tendon/gcm/server/server.h>
#include <tendon/gcm/text/audit_object.h>
#include <tendon/gcm/text/wall_time.h>
#include <tendon/process/access/guarded_handler.h>
#include <tendon/process/telemetry/broadcast_messages.h>
#include <tendon/process/version_messages.h>
#include <tendon/process/watch_over.h>

#include <map>
#include <utility>

namespace tendon::server {
namespace {

constexpr std::chrono::milliseconds kTick(100);

/// Answers with any type of result.
auto AnswerOf(const std::shared_ptr<Responder>& responder) {
  return [responder](const auto& result) { responder->Answer(result); };
}

}  // namespace

/// One channel, of an LCM or a viewer.
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
    responder.Refuse({ErrorCode::kInvalid, "a GCM does not understand message " +
                                               std::to_string(static_cast<unsigned>(header.type))});
  }

  void OnAllowedNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                       std::span<const std::byte> body) override {
    if (header.type == message::kReport) server_->Report(*this, body);
    if (header.type == message::kLogRecords) server_->TakeLog(session, body);
  }

  void OnClosed(const std::shared_ptr<Channel>& channel, const Error& reason) override {
    server_->Closed(*this, channel, reason);
  }

  [[nodiscard]] std::string ObjectOf(const FrameHeader& header,
                                     std::span<const std::byte> body) const override {
    return AuditObject(header.type, body);
  }

  Session session = 0;  // guarded by the server's lock; 0: not a member

 private:
  const std::shared_ptr<Server> server_;
};

std::string Server::NameOf(const Channel& channel) { return Printable(channel.peer().name, 64); }

Server::Server(Options options)
    : options_(std::move(options)),
      history_(options_.history),
      registry_(options_.leases, *options_.clock) {}

/// Returns the part's Locked function.
template <typename Part>
auto Server::LockedWith(std::unique_ptr<Part> Server::*part) {
  return [weak = weak_from_this(), part](const std::function<void(Part&)>& action) {
    if (const auto self = weak.lock()) self->Locked([&] { action(*((*self).*part)); });
  };
}

void Server::Start() {
  life_ = std::make_unique<LifeOrders>(LifeOrders::Parts{registry_, history_, outbox_, worker_},
                                       LockedWith(&Server::life_), options_.order_timeout);
  supervisor_ = std::make_unique<Supervisor>(
      Supervisor::Parts{registry_, history_, outbox_, *options_.clock, options_.launcher},
      LockedWith(&Server::supervisor_));
  orders_ = std::make_unique<Orders>(
      Orders::Parts{registry_, history_, outbox_, worker_, *life_, *supervisor_},
      LockedWith(&Server::orders_), options_.order_timeout);
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
      outbox_.Add([channel] { channel->Close(); });
    }
    supervisor_->Tick();
    if (std::exchange(peers_owed_, false)) SendPeers();
    outbox_.Add([this] {
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
    if (ChangesProcesses(changes)) TellPeers();
    outbox_.Add([this, changes = std::move(changes)] {
      watchers_.Publish(changes);
      LogProcesses(changes);
      for (const CatalogueChange& change : changes) {
        if (change.kind == CatalogueChange::Kind::kProcessRemoved) log_book_.Forget(change.process);
      }
    });
  }
  for (const message::Wire& wire : registry_.TakeDueHandBacks()) orders_->HandBack(wire);
}

/// Sends the list of processes at once, but at most once per tick. Otherwise many processes that
/// join together would keep the GCM and each other too busy to renew their leases.
void Server::TellPeers() {
  if (SteadyClock().Now() - peers_told_ < kTick) {
    peers_owed_ = true;
  } else {
    SendPeers();
  }
}

void Server::SendPeers() {
  peers_told_ = SteadyClock().Now();
  const auto body = std::make_shared<const Bytes>(EncodeBody(registry_.peers()));
  for (const auto& channel : registry_.channels()) {
    outbox_.Add([this, channel, body] {
      const Status status = channel->Notify(message::kPeers, 0, *body);
      if (status.code() != Status::kQueueFull) return;
      const std::scoped_lock lock(mutex_);
      peers_owed_ = true;
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
      {message::kHistory, &Server::Tell},
      {message::kForget, &Server::Forget},
      {message::kReplace, &Server::Replace},
      {message::kWatchLog, &Server::WatchLog},
      {message::kSetLogLevel, &Server::SetLogLevel},
      {message::kLife, &Server::Steer},
      {message::kGetClasses, &Server::ListClasses},
      {message::kPassOver, &Server::PassOver},
      {message::kPlanLock, &Server::TakePlanTurn},
      {message::kBeginOrder, &Server::BeginOrder},
      {message::kHealth, &Server::TellHealth},
      {message::kTellHealth, &Server::TakeHealth},
      {message::kFanOut, &Server::TellFanOut},
      {message::kProcess, &Server::SteerProcess},
      {message::kGetProgram, &Server::TellVersion},
      {message::kGetChildren, &Server::TellChildren}};
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
                                 "': under TLS that takes a certificate of that name (gcm cert "
                                 "issue " +
                                 name + " --role operator --process)"});
  }
  Locked([&] {
    Session& session = request.peer.session;
    if (session != 0) {
      return Answer<message::JoinReply>(
          request, Error{ErrorCode::kInvalid, "this channel has already joined"});
    }
    auto admission =
        registry_.Join(*std::move(join), request.channel->peer().session, request.channel);
    if (!admission) {
      audit_.Write(peer, LogLevel::kWarning,
                   who + ": join: refused: " + Printable(admission.error().message, 256));
      return Answer<message::JoinReply>(request, admission.error());
    }
    audit_.Write(peer, LogLevel::kInfo, who + ": join: allowed");
    session = admission->session;
    if (admission->replaced) outbox_.Add([old = admission->replaced] { old->Close(); });
    Answer(request, Result(message::JoinReply{.gcm_instance = options_.instance,
                                              .session = session,
                                              .processes = registry_.peers().processes}));
  });
}

/// Renews a lease; from a viewer it is only a ping. The answer has its own lane, so that it does
/// not wait behind a large one.
void Server::Renew(const Request& request) {
  Locked([&] {
    const Session session = request.peer.session;
    const auto renewed = session == 0 ? Result<void>() : registry_.Renew(session);
    if (!renewed) return Answer(request, renewed);
    outbox_.Add(
        [responder = request.responder] { responder->Reply(EncodeBody(None{}), kOwnLane); });
  });
}

/// The answer contains the time, so it must not wait behind other answers.
void Server::TakeHealth(const Request& request) {
  const message::GcmClock now{SteadyClock().Now().time_since_epoch().count()};
  const auto health = DecodeBody<message::Health>(request.body);
  if (!health) return request.responder->Refuse(health.error());
  Locked([&] {
    const auto taken = registry_.TakeHealth(request.peer.session, *health);
    if (!taken) return Answer(request, taken);
    outbox_.Add(
        [responder = request.responder, now] { responder->Reply(EncodeBody(now), kOwnLane); });
  });
}

void Server::Leave(const Request& request) {
  Locked([&] {
    registry_.End(std::exchange(request.peer.session, 0), ProcessState::kLeft, "deregistered");
    Answer(request, Result<void>());
  });
}

void Server::Watch(const Request& request) {
  Locked([&] {
    const Catalogue& catalogue = registry_.catalogue();
    message::Snapshot snapshot{.gcm_instance = options_.instance, .changes = catalogue.AsChanges()};
    snapshot.base = catalogue.revision() - snapshot.changes.size();
    Answer(request, Result(std::move(snapshot)));
    outbox_.Add([this, channel = request.channel, revision = catalogue.revision()] {
      if (channel->is_open()) watchers_.Add(channel, revision);
    });
  });
}

void Server::Connect(const Request& request) {
  const auto wire = DecodeBody<message::Wire>(request.body);
  if (!wire) return request.responder->Refuse(wire.error());
  Locked([&] { orders_->Connect(*wire, NameOf(*request.channel), AnswerOf(request.responder)); });
}

void Server::Replace(const Request& request) {
  const auto wire = DecodeBody<message::Wire>(request.body);
  if (!wire) return request.responder->Refuse(wire.error());
  Locked([&] { orders_->Replace(*wire, NameOf(*request.channel), AnswerOf(request.responder)); });
}

void Server::Disconnect(const Request& request) {
  const auto wire = DecodeBody<message::Wire>(request.body);
  if (!wire) return request.responder->Refuse(wire.error());
  Locked([&] {
    orders_->Disconnect(wire->required, NameOf(*request.channel), AnswerOf(request.responder));
  });
}

void Server::Steer(const Request& request) {
  const auto order = DecodeBody<message::LifeOrder>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] {
    supervisor_->NoteChange(order->process);
    life_->Steer(*order, NameOf(*request.channel), AnswerOf(request.responder));
  });
}

void Server::SteerProcess(const Request& request) {
  const auto order = DecodeBody<message::ProcessOrder>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] { supervisor_->Obey(*order, NameOf(*request.channel), AnswerOf(request.responder)); });
}

void Server::ListClasses(const Request& request) {
  const auto wanted = DecodeBody<message::GetClasses>(request.body);
  if (!wanted) return request.responder->Refuse(wanted.error());
  Locked([&] { life_->ListClasses(wanted->process, AnswerOf(request.responder)); });
}

void Server::BeginOrder(const Request& request) {
  const auto order = DecodeBody<message::BeginOrder>(request.body);
  if (!order) return request.responder->Refuse(order.error());
  Locked([&] {
    const ProcessDescription* const member = registry_.FindMember(request.peer.session);
    const std::string name = member == nullptr ? "" : member->name;
    supervisor_->NoteChange(name);
    Answer(request, life_->Begin(order->id, name));
  });
}

void Server::Undo(const Request& request) {
  const auto which = DecodeBody<message::StepSelection>(request.body);
  if (!which) return request.responder->Refuse(which.error());
  Locked([&] { orders_->Undo(*which, NameOf(*request.channel), AnswerOf(request.responder)); });
}

void Server::PassOver(const Request& request) {
  const auto which = DecodeBody<message::StepSelection>(request.body);
  if (!which) return request.responder->Refuse(which.error());
  Locked([&] { orders_->PassOver(*which, NameOf(*request.channel), AnswerOf(request.responder)); });
}

void Server::TakePlanTurn(const Request& request) {
  const auto turn = DecodeBody<message::PlanLock>(request.body);
  if (!turn) return request.responder->Refuse(turn.error());
  Locked([&] {
    const bool is_free = plan_turn_.peer == nullptr || plan_turn_.peer == &request.peer;
    if (is_free && !turn->is_wanted) plan_turn_ = {};
    if (is_free && turn->is_wanted && plan_turn_.peer == nullptr) {
      plan_turn_ = {&request.peer, NameOf(*request.channel), WallTime()};
    }
    const bool is_granted = is_free || !turn->is_wanted;
    Answer(request, is_granted
                        ? Result<void>()
                        : Error{ErrorCode::kFailed,
                                "nothing was done, because a plan of " + plan_turn_.who +
                                    " has been running since " + WallTimeText(plan_turn_.since) +
                                    "; try again when that is done"});
  });
}

void Server::Tell(const Request& request) { request.responder->Answer(Result(history_.steps())); }

void Server::TellFanOut(const Request& request) {
  request.responder->Answer(Result(message::BroadcastAddress{options_.fan_out}));
}

void Server::TellVersion(const Request& request) {
  request.responder->Answer(Result(OwnVersion()));
}

void Server::TellChildren(const Request& request) {
  Locked([&] { Answer(request, Result(supervisor_->children())); });
}

void Server::TellHealth(const Request& request) {
  Locked([&] { Answer(request, Result(registry_.health())); });
}

void Server::Forget(const Request& request) {
  const auto forget = DecodeBody<message::Forget>(request.body);
  if (!forget) return request.responder->Refuse(forget.error());
  Locked([&] { Answer(request, registry_.Forget(forget->process)); });
}

void Server::Report(const Peer& peer, std::span<const std::byte> body) {
  auto report = DecodeBody<message::Report>(body);
  Locked([&] {
    const auto reported =
        report ? registry_.Report(peer.session, *std::move(report)) : Result<void>(report.error());
    if (reported) return;
    outbox_.Add([this, text = reported.error().message] {
      not_understood_.Add("a report was not understood: " + text);
    });
  });
}

void Server::Closed(Peer& peer, const SharedChannel& channel, const Error& reason) {
  Locked([&] {
    if (plan_turn_.peer == &peer) plan_turn_ = {};
    registry_.End(std::exchange(peer.session, 0), ProcessState::kLost,
                  "its connection broke: " + Printable(reason.message, 256));
    outbox_.Add([this, key = channel.get()] {
      watchers_.Remove(key);
      log_book_.Remove(key);
    });
  });
}

}  // namespace tendon::server
