#include <tendon/proxy/required_interface_proxy.h>

#include <tendon/base/text.h>
#include <tendon/middleware/large_message_in_progress.h>
#include <tendon/proxy/read_offer_proxy.h>

#include <algorithm>
#include <functional>
#include <span>
#include <thread>
#include <utility>

namespace tendon {
namespace {

/// The longest time for which a read may be queued. The caller's deadline (by default 100 ms) is
/// not known here.
constexpr std::chrono::seconds kMaxReadWait(2);
constexpr std::size_t kMaxReads = 64;
constexpr std::size_t kMaxReadBytes = std::size_t{64} << 20U;

/// The largest number of event bytes that may be queued for a connected peer. Further events are
/// lost and counted.
constexpr std::size_t kMaxEventBytes = std::size_t{64} << 20U;
/// The limit for a peer that only receives events. It is smaller, because there may be many such
/// peers.
constexpr std::size_t kMaxHeardBytes = std::size_t{8} << 20U;

/// Writes the result of a read and the status as the reply. If the link has memory for the reply,
/// writes directly into this memory.
class ReadReply final : public ReplySink {
 public:
  /// `may_be` returns true if a value of this size may be sent. If the link has no memory for the
  /// reply, `spare` is the buffer of the reply.
  ReadReply(Responder responder, std::function<bool(std::size_t)> may_be, Bytes& spare)
      : responder_(std::move(responder)), may_be_(std::move(may_be)), spare_(spare) {}

  std::span<std::byte> Room(std::size_t size) override {
    is_refused_ = !may_be_(size);
    return is_refused_ ? std::span<std::byte>() : Begin(size).first(size);
  }

  /// Sends the reply. If there is no value, sends only the status. Must be called once.
  void Finish(Status status) {
    if (reply_.empty()) Begin(0);
    if (is_refused_) status = Status::kFailed;
    if (!status) std::ranges::fill(reply_, std::byte{0});  // they may contain other data
    reply_.back() = CodeOf(status);
    if (is_in_place_) return responder_.EndReply();
    responder_.Reply(reply_, kOwnLane);
  }

 private:
  std::span<std::byte> Begin(std::size_t size) {
    const std::size_t with_status = size + 1;
    reply_ = responder_.BeginReply(with_status);
    is_in_place_ = !reply_.empty();
    if (!is_in_place_) {
      spare_.resize(with_status);
      reply_ = spare_;
    }
    return reply_;
  }

  Responder responder_;
  const std::function<bool(std::size_t)> may_be_;
  Bytes& spare_;
  std::span<std::byte> reply_;
  bool is_in_place_ = false;
  bool is_refused_ = false;
};

void ReplyWith(Status refusal, Responder& responder) {
  Bytes reply;
  AppendStatus(refusal, reply);
  responder.Reply(reply, kOwnLane);
}

}  // namespace

RequiredInterfaceProxy::RequiredInterfaceProxy(std::shared_ptr<NetworkThread> thread,
                                               std::shared_ptr<Channel> channel,
                                               const message::OpenInterface& open, Events events)
    : thread_(std::move(thread)),
      channel_(std::move(channel)),
      handle_(open.handle),
      capacity_(open.capacity),
      outbox_(channel_, events == Events::kTimed ? message::kTimedEvents : message::kEvents,
              thread_->wakeup(), ToString(open.provided),
              {.waiting_bytes = events == Events::kTimed ? kMaxHeardBytes : kMaxEventBytes}),
      loss_report_(channel_, handle_),
      interface_(open.description.name, &outbox_.inbox()),
      runs_component_(open.description.functions.size()) {
  if (events == Events::kTimed) {
    outbox_.SendTimesOf(interface_);
    interface_.ObserveCalls();
  }
  for (const MemberDescription& function : open.description.functions) {
    functions_.push_back(std::make_unique<FunctionProxy>(interface_, function));
    function_names_.push_back(function.name);
  }
  std::uint32_t handle = handle_;
  for (const MemberDescription& handler : open.description.event_handlers) {
    auto offer = std::make_unique<QueuedOfferProxy>(handler, outbox_, ++handle);
    offer->SetOverflow(OverflowOf(open.latest_only, handler.name));
    handlers_.push_back(offer.get());
    interface_.AddOffer(std::move(offer));
  }
  interface_.SetMailboxCapacity(capacity_);
  interface_.Seal();
}

void RequiredInterfaceProxy::MakeExecutors(const ProvidedInterface& server,
                                           CallExecutors& threads) {
  bool has_commands = false;
  bool has_reads = false;
  for (std::size_t i = 0; i < functions_.size(); ++i) {
    const Offer* offer = server.FindCommand(function_names_[i]);
    runs_component_[i] = offer != nullptr && offer->RunsInCaller(server.inbox() != nullptr);
    if (!runs_component_[i]) continue;
    (CanBeAwaited(functions_[i]->kind()) ? has_commands : has_reads) = true;
  }
  // The queue has room for the whole credit of the peer, with arguments of any size, and for one
  // call that has just ended.
  if (has_commands) commands_ = threads.commands.MakeExecutor(capacity_ + std::size_t{1});
  if (has_reads) reads_ = threads.reads.MakeExecutor(kMaxReads, kMaxReadBytes);
  if (has_commands || has_reads) interface_.SetCallers(CallerThreads::kManyThreads);
}

void RequiredInterfaceProxy::PrepareObservers(const ProvidedInterface& server) {
  if (!interface_.observes_calls()) return;
  for (QueuedOfferProxy* handler : handlers_) {
    if (server.FindCommand(handler->description().name) != nullptr) handler->SetObservesCalls();
  }
}

bool RequiredInterfaceProxy::BeginCredit(const Connection& connection, Server server) {
  const std::scoped_lock lock(mutex_);
  connection_ = &connection;
  server_ = std::move(server);
  reported_.accepting = IsAccepting();
  return reported_.accepting;
}

/// Returns true if the server executes calls now. Without an inbox, the state of the component
/// decides.
bool RequiredInterfaceProxy::IsAccepting() const {
  if (const Inbox* inbox = server_.interface->inbox()) return inbox->accepting();
  const ComponentAccess* component = server_.interface->component();
  return component == nullptr || component->accepting();
}

/// Returns why the component is faulted. The text may come from any exception, so Printable()
/// shortens it to a length that catalogues accept.
std::string RequiredInterfaceProxy::Fault() const {
  const ComponentAccess* component = server_.interface->component();
  return component != nullptr && component->is_faulted() ? Printable(server_.fault())
                                                         : std::string();
}

bool RequiredInterfaceProxy::Drain(SteadyTime deadline) const {
  const bool is_executed = !commands_ || commands_->Drain(deadline);
  const bool is_read = !reads_ || reads_->Drain(SteadyTime{});
  return is_executed && is_read;
}

void RequiredInterfaceProxy::EndCredit() {
  const std::scoped_lock lock(mutex_);
  executing_.GiveUp();
  connection_ = nullptr;
  server_ = {};
}

template <typename Call>
bool RequiredInterfaceProxy::PostTo(SerialExecutor& executor, std::span<const std::byte> argument,
                                    Call call) {
  return executor.Post([self = shared_from_this(), call = std::move(call),
                        bytes = Bytes(argument.begin(), argument.end())] { call(*self, bytes); },
                       argument.size());
}

class RequiredInterfaceProxy::QueuedCommandCount {
 public:
  /// Must be created before the command is counted as received.
  explicit QueuedCommandCount(RequiredInterfaceProxy& proxy) : proxy_(proxy) {}
  QueuedCommandCount(const QueuedCommandCount&) = delete;
  QueuedCommandCount& operator=(const QueuedCommandCount&) = delete;
  /// Destroyed when the command was executed, moved to the mailbox, or dropped.
  ~QueuedCommandCount() {
    const std::scoped_lock lock(proxy_.mutex_);
    --proxy_.queued_in_executor_;
  }

 private:
  RequiredInterfaceProxy& proxy_;
};

void RequiredInterfaceProxy::LogDropped(std::size_t function, const std::string& reason) {
  warnings_.Add("a call of '" + function_names_[function] + "' from " + channel_->peer().name +
                " was dropped: " + reason);
}

void RequiredInterfaceProxy::LogRefused(std::size_t function) {
  LogDropped(function, std::to_string(capacity_) +
                           " calls are already queued, or there is not enough memory");
}

/// Returns true if a call of this command must be queued in the serial executor.
bool RequiredInterfaceProxy::MustUseExecutor(std::size_t function) const {
  if (!commands_ || runs_component_[function]) return commands_ != nullptr;
  const std::scoped_lock lock(mutex_);
  return queued_in_executor_ > 0;
}

void RequiredInterfaceProxy::WaitForRoom(std::size_t function, SteadyTime deadline) const {
  constexpr std::chrono::milliseconds kUntilNextLook(1);
  const auto is_full = [this] {
    const std::scoped_lock lock(mutex_);
    return connection_ != nullptr && connection_->waiting() >= connection_->capacity();
  };
  if (runs_component_[function]) return;
  while (!are_commands_dropped_.Get() && SteadyClock().Now() < deadline && is_full()) {
    std::this_thread::sleep_for(kUntilNextLook);
  }
}

void RequiredInterfaceProxy::OnCommand(std::size_t function, std::span<const std::byte> argument) {
  if (function >= functions_.size() || !IsQueued(functions_[function]->kind())) return;
  // A command that is refused here is counted as executed.
  if (!MustUseExecutor(function)) {
    const Status status = (*functions_[function])(argument, reply_);
    if (status == Status(Status::kInvalid) || status == Status(Status::kFailed)) {
      LogDropped(function, "the argument of the call cannot be decoded");
    }
    if (status != Status(Status::kQueueFull)) return CountReceived(CreditReporting::kPrompt);
    // The peer need not have exceeded its credit. A reply confirms all earlier calls, even calls
    // that are still queued here.
    if (!commands_) {
      LogRefused(function);
      return CountReceived(CreditReporting::kPrompt);
    }
  }
  auto place = std::make_shared<QueuedCommandCount>(*this);
  CountReceived(CreditReporting::kPrompt, 1);
  const bool is_posted = PostTo(
      *commands_, argument, [function, place = std::move(place)](auto& self, const Bytes& bytes) {
        self.WaitForRoom(function, SteadyTime::max());
        if (self.are_commands_dropped_.Get()) return;
        Bytes nothing;
        (void)(*self.functions_[function])(bytes, nothing);
      });
  if (!is_posted) LogRefused(function);
}

void RequiredInterfaceProxy::CountReceived(CreditReporting reporting, std::uint64_t in_executor) {
  std::unique_lock lock(mutex_);
  ++received_;
  queued_in_executor_ += in_executor;
  if (reporting_ >= reporting) return;
  if (reporting == CreditReporting::kRelaxed) owed_since_ = SteadyClock().Now();
  reporting_ = reporting;
  lock.unlock();
  thread_->Notify();
}

void RequiredInterfaceProxy::OnRead(std::size_t function, std::span<const std::byte> argument,
                                    Responder responder) {
  if (function >= functions_.size() || CanBeAwaited(functions_[function]->kind())) {
    return responder.Refuse({ErrorCode::kInvalid, "no such read in " + interface_.name()});
  }
  if (!runs_component_[function]) {
    const LargeMessageInProgress mark;  // the reply may be large
    return Read(function, argument, std::move(responder), reply_);
  }
  responder.Defer();
  const auto shared = std::make_shared<Responder>(std::move(responder));
  const auto read = [function, shared, since = SteadyClock().Now()](auto& self,
                                                                    const Bytes& bytes) {
    if (self.IsStale(since)) return ReplyWith(Status::kTimeout, *shared);
    Bytes spare;
    self.Read(function, bytes, std::move(*shared), spare);
  };
  const bool is_posted = PostTo(*reads_, argument, read);
  if (!is_posted) ReplyWith(Status::kQueueFull, *shared);
}

/// Returns true if the caller of a read that was queued at `since` has probably timed out.
bool RequiredInterfaceProxy::IsStale(SteadyTime since) const {
  const bool is_late = SteadyClock().Now() - since > kMaxReadWait;
  return is_late || are_reads_dropped_.Get() || !channel_->is_open();
}

void RequiredInterfaceProxy::Read(std::size_t function, std::span<const std::byte> argument,
                                  Responder responder, Bytes& spare) {
  const auto can_be_sent = [&](std::size_t size) { return CanBeSent(function, size); };
  ReadReply reply(std::move(responder), can_be_sent, spare);
  reply.Finish((*functions_[function])(argument, reply));
}

bool RequiredInterfaceProxy::CanBeSent(std::size_t function, std::size_t size) {
  if (size <= kMaxPayload) return true;
  outbox_.refused_payloads().Log(function_names_[function], size);
  return false;
}

void RequiredInterfaceProxy::OnWait(std::size_t function, std::span<const std::byte> argument,
                                    Responder responder) {
  const auto timeout = TakeTimeout(argument);
  if (!timeout || function >= functions_.size() || !CanBeAwaited(functions_[function]->kind())) {
    return responder.Refuse({ErrorCode::kInvalid, "no such command in " + interface_.name()});
  }
  const SteadyTime now = SteadyClock().Now();
  ExecutingCalls::ExecutingCall executing{.since = now,
                                          .deadline = now + *timeout,
                                          .function = function,
                                          .responder = std::move(responder)};
  const CreditReporting reporting =
      executing.responder.Defer() ? CreditReporting::kRelaxed : CreditReporting::kPrompt;
  if (!MustUseExecutor(function)) {
    const Status status = Begin(executing, argument, reply_);
    CountReceived(reporting);
    return OnStarted(std::move(executing), status, reply_);
  }
  const auto shared = std::make_shared<ExecutingCalls::ExecutingCall>(std::move(executing));
  auto place = std::make_shared<QueuedCommandCount>(*this);
  CountReceived(reporting, 1);
  const bool is_posted = PostTo(
      *commands_, argument, [shared, place = std::move(place)](auto& self, const Bytes& bytes) {
        self.WaitForRoom(shared->function, shared->deadline);
        if (self.are_commands_dropped_.Get()) {
          return ReplyWith(Status::kNotConnected, shared->responder);
        }
        Bytes spare;
        const bool is_over = SteadyClock().Now() >= shared->deadline;
        const Status status = is_over ? Status::kTimeout : self.Begin(*shared, bytes, spare);
        self.OnStarted(std::move(*shared), status, spare);
      });
  if (!is_posted) ReplyWith(Status::kQueueFull, shared->responder);
}

Status RequiredInterfaceProxy::Begin(ExecutingCalls::ExecutingCall& executing,
                                     std::span<const std::byte> argument, Bytes& result) {
  return functions_[executing.function]->Begin(argument, result, thread_->wakeup(),
                                               executing.command, executing.call);
}

void RequiredInterfaceProxy::OnStarted(ExecutingCalls::ExecutingCall executing, Status status,
                                       Bytes& result) {
  if (status != Status(Status::kQueued)) return OnEnd(executing, status, result);
  SteadyTime look = ExecutingCalls::FirstLook(executing);
  {
    const std::scoped_lock lock(mutex_);
    // The connection has been closed. The call was either executed or dropped.
    if (connection_ == nullptr) return OnEnd(executing, Status::kOutcomeUnknown, result);
    // If the call ended before Add(), there is no further notification.
    if (executing.command->HasEnded(executing.call)) look = executing.since;
    executing_.Add(std::move(executing));
  }
  thread_->NotifyBy(look);
}

void RequiredInterfaceProxy::OnEnd(ExecutingCalls::ExecutingCall& executing, Status status,
                                   Bytes& result) {
  if (!CanBeSent(executing.function, result.size())) status = Status::kFailed;
  if (!status) result.clear();
  AppendStatus(status, result);
  executing.responder.Reply(result, kOwnLane);
}

void RequiredInterfaceProxy::OnEventsLost(const message::EventsLost& events) {
  std::uint64_t lost = 0;
  for (const std::uint64_t one : events.lost) lost += one;
  lost_there_.Set(lost);
}

std::uint64_t RequiredInterfaceProxy::lost_events() const {
  std::uint64_t lost = lost_there_.Get();
  for (const QueuedOfferProxy* handler : handlers_) lost += handler->refused();
  return lost;
}

std::uint64_t RequiredInterfaceProxy::received() const {
  const std::scoped_lock lock(mutex_);
  return received_;
}

bool RequiredInterfaceProxy::Work(SteadyTime now, SteadyTime& next) {
  constexpr std::chrono::milliseconds kUntilLinkHasRoom(1);
  constexpr std::size_t kCallsInARow = 1024;
  const std::size_t sent = outbox_.Send(kCallsInARow);
  if (outbox_.is_held_up()) next = std::min(next, now + kUntilLinkHasRoom);
  SendCredit(now, next);
  for (std::size_t i = 0; i < handlers_.size(); ++i) loss_report_.Set(i, handlers_[i]->refused());
  loss_report_.Report(now, next);
  return sent > 0;
}

/// Returns true if a report must be sent now: if the state has changed, or if the unreported calls
/// reach half the credit of the peer and no replies have reported them. All other reports can wait.
bool RequiredInterfaceProxy::IsUrgent(const message::Credit& credit) const {
  if (credit.accepting != reported_.accepting || credit.fault != reported_.fault) return true;
  return reporting_ != CreditReporting::kRelaxed &&
         2 * (credit.executed - reported_.executed) >= capacity_;
}

/// Sends a Credit if it is due. Sends one from time to time even if replies have reported all
/// calls, because a peer ignores a reply whose caller has timed out.
void RequiredInterfaceProxy::SendCredit(SteadyTime now, SteadyTime& next) {
  constexpr std::chrono::milliseconds kLatest(4);
  constexpr std::chrono::milliseconds kLatestBehindReplies(100);
  constexpr std::chrono::milliseconds kUntilNextLook(1);
  const std::scoped_lock lock(mutex_);
  if (connection_ == nullptr) return;
  executing_.SendReplies(now, next);
  if (!channel_->is_open()) return;
  // This order of reads matters. If a call is posted during the reads, `executed` becomes too
  // small, never too large.
  const std::uint64_t received = received_;
  const std::uint64_t waiting = queued_in_executor_ + connection_->waiting();
  const std::uint64_t executed = received - std::min(waiting, received);
  const message::Credit credit{.executed = std::max(executed, reported_.executed),
                               .accepting = IsAccepting(),
                               .fault = Fault()};
  const bool is_close = reporting_ != CreditReporting::kRelaxed;
  const auto latest = is_close ? kLatest : kLatestBehindReplies;
  if (credit == reported_) {
    owed_since_ = now;
  } else if (IsUrgent(credit) || now - owed_since_ >= latest) {
    if (channel_->Notify(message::kCredit, handle_, credit)) reported_ = credit;
  }
  if (reported_.executed == received && credit == reported_) {
    reporting_ = CreditReporting::kIdle;
    return;
  }
  if (reporting_ == CreditReporting::kIdle) reporting_ = CreditReporting::kPrompt;
  const bool is_later =
      reporting_ == CreditReporting::kRelaxed && now - owed_since_ < kLatestBehindReplies;
  next = std::min(next, is_later ? owed_since_ + kLatestBehindReplies : now + kUntilNextLook);
}

}  // namespace tendon
