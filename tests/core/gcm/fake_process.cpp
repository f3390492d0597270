#include <tendon/base/os/process.h>
#include <tendon/payload/codec.h>
#include <tendon/process/history/history_messages.h>
#include <tendon/proxy/call_batch.h>
#include <tendon/proxy/connection_messages.h>
#include <tests/core/gcm/fake_process.h>

#include <functional>
#include <utility>

namespace tendon::test {
namespace {

using Kind = CatalogueChange::Kind;

constexpr std::chrono::milliseconds kTimeout(60'000);

Hello HelloOf(const ProcessDescription& process, std::uint64_t session) {
  return {.instance = process.instance,
          .name = process.name,
          .session = session,
          .cookie = *LoopbackCookie()};
}

}  // namespace

class FakeProcess::State final : public ChannelHandler, public std::enable_shared_from_this<State> {
 public:
  void OnRequest(const std::shared_ptr<Channel>& channel, const FrameHeader& header,
                 std::span<const std::byte> body, Responder responder) override {
    if (header.type == message::kMakeConnection) {
      Make(channel, *DecodeBody<message::ConnectionPlan>(body), std::move(responder));
    } else if (header.type == message::kBreakConnection) {
      Break(channel, *DecodeBody<message::ConnectionEnds>(body), std::move(responder));
    } else if (header.type == message::kGetSchemas) {
      responder.ReplyWith(Result(SchemasOf(*DecodeBody<message::GetSchemas>(body))));
    } else if (header.type == message::kCallMember) {
      responder.ReplyWith(Result(Call(*DecodeBody<message::CallMember>(body))));
    } else if (header.type == message::kPing) {
      responder.ReplyWith(Result(Clock()));
    } else if (header.type == message::kReadEvents) {
      const std::scoped_lock lock(mutex);
      readers.push_back(std::move(responder));
    } else if (header.type == message::kListen) {
      const std::scoped_lock lock(mutex);
      listener = channel;
      listener_handle = DecodeBody<message::OpenInterface>(body)->handle;
      responder.ReplyWith(Result(message::OpenInterfaceReply{.handle = 1, .accepting = true}));
    }
  }

  void OnNotice(const std::shared_ptr<Channel>& /*channel*/, const FrameHeader& header,
                std::span<const std::byte> body) override {
    const std::scoped_lock lock(mutex);
    if (header.type == message::kPeers) peers = *DecodeBody<message::PeerList>(body);
  }

  void OnClosed(const std::shared_ptr<Channel>& closed, const Error& /*reason*/) override {
    const std::scoped_lock lock(mutex);
    if (gcm == closed) gcm.reset();
  }

  void Make(const std::shared_ptr<Channel>& channel, const message::ConnectionPlan& plan,
            Responder responder) {
    const std::scoped_lock lock(mutex);
    orders.push_back(plan);
    if (manners == Manners::kDelayFromConnect) manners = Manners::kDelay;
    if (Delays([=, this](Responder late) { MakeNow(channel, plan, std::move(late)); }, responder))
      return;
    MakeNow(channel, plan, std::move(responder));
  }

  void MakeNow(const std::shared_ptr<Channel>& channel, const message::ConnectionPlan& plan,
               Responder responder) {
    if (manners == Manners::kRefuseConnects || manners == Manners::kRefuseTheNextConnect) {
      if (manners == Manners::kRefuseTheNextConnect) manners = Manners::kObey;
      return responder.Refuse({ErrorCode::kFailed, "teleoperation is busy"});
    }
    if (!Obeys(std::move(responder))) return;
    const bool is_missed = manners == Manners::kMissTheNextProvider;
    if (is_missed) manners = Manners::kObey;
    const bool is_there = !plan.address.empty() && !is_missed;
    const ConnectionDescription made{
        .id = ++last_id,
        .required = plan.ends.required,
        .provided = plan.ends.provided,
        .state = is_there ? ConnectionState::kActive : ConnectionState::kPending,
        .reason = is_missed ? "nobody answers" : ""};
    connections[made.required] = made;
    static_cast<void>(
        channel->Notify(message::kReport, 0,
                        message::Report{{{.kind = Kind::kConnection, .connections = {made}}}}));
    if (manners == Manners::kObeyAndDie) return channel->Close();
    kept->ReplyWith(Result(made));
    kept.reset();
  }

  void Break(const std::shared_ptr<Channel>& channel, const message::ConnectionEnds& ends,
             Responder responder) {
    const std::scoped_lock lock(mutex);
    if (Delays([=, this](Responder late) { BreakNow(channel, ends, std::move(late)); }, responder))
      return;
    BreakNow(channel, ends, std::move(responder));
  }

  void BreakNow(const std::shared_ptr<Channel>& channel, const message::ConnectionEnds& ends,
                Responder responder) {
    if (!Obeys(std::move(responder))) return;
    const auto id = connections[ends.required].id;
    connections.erase(ends.required);
    static_cast<void>(
        channel->Notify(message::kReport, 0,
                        message::Report{{{.kind = Kind::kConnectionRemoved, .connection = id}}}));
    if (manners == Manners::kObeyAndDie) return channel->Close();
    kept->ReplyWith(Result<void>());
    kept.reset();
  }

  /// If orders are delayed, stores this order for CatchUp() and returns true.
  bool Delays(std::function<void(Responder)> order, Responder& responder) {
    if (manners != Manners::kDelay) return false;
    delayed.emplace_back(std::move(order), std::move(responder));
    return true;
  }

  void CatchUp() {
    for (auto& [order, responder] : std::exchange(delayed, {})) order(std::move(responder));
  }

  /// Stores the responder, or refuses the order. Returns false if the order must not be executed.
  bool Obeys(Responder responder) {
    if (manners == Manners::kRefuse) {
      responder.Refuse({ErrorCode::kFailed, "teleoperation is busy"});
      return false;
    }
    kept.emplace(std::move(responder));
    return manners != Manners::kSayNothing;
  }

  message::Schemas SchemasOf(const message::GetSchemas& wanted) {
    const std::scoped_lock lock(mutex);
    ++schema_requests;
    message::Schemas schemas;
    for (const Fingerprint& fingerprint : wanted.fingerprints) {
      const auto known = texts.find(fingerprint);
      schemas.texts.push_back(known == texts.end() ? "" : known->second);
    }
    return schemas;
  }

  message::Pong Clock() {
    const std::scoped_lock lock(mutex);
    ++clock_requests;
    const SteadyTime now = SteadyClock().Now() + clock_ahead;
    return {.time = std::chrono::nanoseconds(now.time_since_epoch()).count()};
  }

  message::CallMemberReply Call(const message::CallMember& call) {
    const std::scoped_lock lock(mutex);
    message::CallMemberReply called;
    Joints joints{1, 2, 3, 4, 5, 6, 7};
    if (call.member == "Stop") return {.status = Status::kNotActive};
    if (call.member == "MoveTo") {
      const bool decodes = Decode(call.argument, joints);
      if (decodes) goal = joints;
      return {.status = decodes ? Status::kQueued : Status::kInvalid};
    }
    if (call.member == "Scale") {
      double factor = 0;
      if (!Decode(call.argument, factor)) return {.status = Status::kInvalid};
      for (double& joint : joints) joint *= factor;
    }
    Encode(joints, called.result);
    return called;
  }

  mutable std::mutex mutex;
  ProcessDescription description;
  std::shared_ptr<Channel> gcm;
  std::uint64_t session = 0;
  Manners manners = Manners::kObey;
  std::map<std::string, ComponentDescription> components;
  std::map<InterfaceName, ConnectionDescription> connections;
  std::map<Fingerprint, std::string> texts = {{FingerprintOf<Joints>(), SchemaOf<Joints>().Text()},
                                              {FingerprintOf<double>(), SchemaOf<double>().Text()}};
  std::uint64_t last_id = 0;
  std::vector<message::ConnectionPlan> orders;
  message::PeerList peers;
  std::optional<Responder> kept;
  std::optional<Joints> goal;
  int schema_requests = 0;
  int clock_requests = 0;
  std::vector<Responder> readers;
  std::chrono::nanoseconds clock_ahead{0};
  std::shared_ptr<Channel> listener;
  std::uint32_t listener_handle = 0;
  std::vector<std::pair<std::function<void(Responder)>, Responder>> delayed;
};

FakeProcess::FakeProcess(std::shared_ptr<Middleware> middleware, const std::string& name)
    : middleware_(std::move(middleware)), state_(std::make_shared<State>()) {
  state_->description = {.name = name,
                         .instance = os::RandomNumber(),
                         .host = "bench",
                         .pid = static_cast<std::int64_t>(os::RandomNumber() % 30000)};
  auto listener = middleware_->Listen(
      "127.0.0.1:0", Channel::Acceptor(HelloOf(state_->description, 0), [state = state_] {
        return std::static_pointer_cast<ChannelHandler>(state);
      }));
  listener_ = *std::move(listener);
  state_->description.address = listener_->address();
}

FakeProcess::~FakeProcess() { BreakLink(); }

void FakeProcess::Add(const ComponentDescription& component) {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->components[component.name] = component;
    if (!state_->gcm) return;
  }
  Report({{.kind = Kind::kComponent, .components = {component}}});
}

void FakeProcess::Remove(const std::string& component) {
  {
    const std::scoped_lock lock(state_->mutex);
    state_->components.erase(component);
  }
  Report({{.kind = Kind::kComponentRemoved, .component = component}});
}

void FakeProcess::Advertise(const std::string& address) {
  const std::scoped_lock lock(state_->mutex);
  state_->description.address = address;
}

void FakeProcess::Know(const Schema& schema) {
  const std::scoped_lock lock(state_->mutex);
  state_->texts[schema.fingerprint()] = schema.Text();
}

Result<message::JoinReply> FakeProcess::Join(const std::string& gcm) {
  message::Join join;
  std::uint64_t session = 0;
  {
    const std::scoped_lock lock(state_->mutex);
    join.process = state_->description;
    for (const auto& [name, component] : state_->components) join.components.push_back(component);
    for (const auto& [name, one] : state_->connections) join.connections.push_back(one);
    session = state_->session;
  }
  const auto channel =
      Channel::Open(*middleware_, gcm, HelloOf(join.process, session), state_, kTimeout);
  if (!channel) return channel.error();
  {
    const std::scoped_lock lock(state_->mutex);
    state_->gcm = *channel;
  }
  auto joined = (*channel)->Call<message::JoinReply>(message::kJoin, 0, join, kTimeout);
  const std::scoped_lock lock(state_->mutex);
  if (joined) state_->session = joined->session;
  return joined;
}

Result<None> FakeProcess::Renew() {
  std::unique_lock lock(state_->mutex);
  const auto channel = state_->gcm;
  lock.unlock();
  if (!channel) return Error{ErrorCode::kUnreachable, "no link"};
  return channel->Call<None>(message::kRenew, 0, None{}, kTimeout);
}

Result<message::GcmClock> FakeProcess::ReportHealth(const message::Health& health) {
  std::unique_lock lock(state_->mutex);
  const auto channel = state_->gcm;
  lock.unlock();
  if (!channel) return Error{ErrorCode::kUnreachable, "no link"};
  return channel->Call<message::GcmClock>(message::kReportHealth, 0, health, kTimeout);
}

Result<None> FakeProcess::Leave() {
  std::unique_lock lock(state_->mutex);
  const auto channel = state_->gcm;
  lock.unlock();
  return channel->Call<None>(message::kLeave, 0, None{}, kTimeout);
}

void FakeProcess::BreakLink() {
  std::unique_lock lock(state_->mutex);
  const auto channel = std::exchange(state_->gcm, nullptr);
  lock.unlock();
  if (channel) channel->Close();
}

void FakeProcess::Report(const std::vector<CatalogueChange>& changes) {
  std::unique_lock lock(state_->mutex);
  const auto channel = state_->gcm;
  lock.unlock();
  if (channel) {
    static_cast<void>(channel->Notify(message::kReport, 0, message::Report{changes}));
  }
}

Status FakeProcess::SendLog(const message::LogRecords& records) {
  std::unique_lock lock(state_->mutex);
  const auto channel = state_->gcm;
  lock.unlock();
  return channel ? channel->Notify(message::kLogRecords, 0, records) : Status::kNotConnected;
}

void FakeProcess::SetClockAhead(std::chrono::nanoseconds ahead) {
  const std::scoped_lock lock(state_->mutex);
  state_->clock_ahead = ahead;
}

void FakeProcess::Raise(double value, SteadyTime when) {
  Bytes body;
  Encode(value, body);
  CallBatch batch;
  const std::scoped_lock lock(state_->mutex);
  batch.AddTimed(state_->listener_handle + 1, body, when);
  static_cast<void>(state_->listener->Notify(message::kTimedEvents, 0, batch.body()));
}

void FakeProcess::set_manners(Manners manners) {
  const std::scoped_lock lock(state_->mutex);
  state_->manners = manners;
  if (manners == Manners::kObey) state_->CatchUp();
}

const ProcessDescription& FakeProcess::description() const { return state_->description; }

std::vector<message::ConnectionPlan> FakeProcess::orders() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->orders;
}

message::PeerList FakeProcess::peers() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->peers;
}

std::size_t FakeProcess::connection_count() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->connections.size();
}

bool FakeProcess::is_linked() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->gcm != nullptr;
}

std::optional<Joints> FakeProcess::goal() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->goal;
}

int FakeProcess::schema_requests() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->schema_requests;
}

std::size_t FakeProcess::waiting_readers() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->readers.size();
}

int FakeProcess::clock_requests() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->clock_requests;
}

}  // namespace tendon::test
