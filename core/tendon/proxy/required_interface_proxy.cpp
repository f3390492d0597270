#include <tendon/base/printable.h>
#include <tendon/middleware/parts/large_in_hand.h>
#include <tendon/proxy/read_proxy.h>
#include <tendon/proxy/required_interface_proxy.h>

#include <algorithm>
#include <functional>
#include <semaphore>
#include <span>
#include <utility>

namespace tendon {
namespace {

/// A call is over soon that takes no longer than this, and a command is quick of which so many in a
/// row were.
constexpr std::chrono::microseconds kSoon(200);
constexpr std::uint8_t kQuickInARow = 8;
/// For so long a thread of the middleware waits for a call that should be over soon. Longer than
/// that, for a timer that comes before the kernel's next tick must be set, which costs more than
/// the call where the machine is a virtual one.
constexpr std::chrono::milliseconds kPatience(5);

/// Of events that wait for a peer, which says how many may; beyond them they are lost, and counted.
constexpr std::size_t kMostEventBytes = std::size_t{64} << 20U;
/// The same for one that only listens, of which there may be many.
constexpr std::size_t kMostHeardBytes = std::size_t{8} << 20U;

/// The right of a thread of the middleware to wait for a component. Few may at a time, in this
/// process: the others serve whoever else asks.
class Waiter {
 public:
  explicit Waiter(bool wanted) : waits_(wanted && Places().try_acquire()) {}
  Waiter(const Waiter&) = delete;
  Waiter& operator=(const Waiter&) = delete;
  ~Waiter() {
    if (waits_) Places().release();
  }
  [[nodiscard]] bool waits() const { return waits_; }

 private:
  static std::counting_semaphore<>& Places() {
    static std::counting_semaphore<> places(2);
    return places;
  }

  const bool waits_;
};

/// The answer to a read: written to where the link sends it from, where there is such a place, and
/// the status behind it.
class ReadReply final : public AnswerSink {
 public:
  /// `may_be` says whether an answer of some size may be sent; `spare` keeps what has no place.
  ReadReply(Responder responder, std::function<bool(std::size_t)> may_be, Bytes& spare)
      : responder_(std::move(responder)), may_be_(std::move(may_be)), spare_(spare) {}

  std::span<std::byte> Room(std::size_t size) override {
    is_refused_ = !may_be_(size);
    return is_refused_ ? std::span<std::byte>() : Begin(size).first(size);
  }

  /// Once; without an answer it is the status alone.
  void Finish(Status status) {
    if (reply_.empty()) Begin(0);
    if (is_refused_) status = Status::kFailed;
    if (!status) std::ranges::fill(reply_, std::byte{0});  // what was not written is of others
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

}  // namespace

RequiredInterfaceProxy::RequiredInterfaceProxy(std::shared_ptr<NetworkThread> thread,
                                               std::shared_ptr<Channel> channel,
                                               const message::OpenInterface& open, Events events,
                                               const std::vector<std::string>& latest_only)
    : thread_(std::move(thread)),
      channel_(std::move(channel)),
      handle_(open.handle),
      capacity_(open.capacity),
      outbox_(channel_, events == Events::kTimed ? message::kTimedEvents : message::kEvents,
              thread_->wakeup(), ToString(open.provided),
              {.waiting_bytes = events == Events::kTimed ? kMostHeardBytes : kMostEventBytes}),
      loss_report_(channel_, handle_),
      interface_(open.description.name, &outbox_.inbox()),
      quick_in_a_row_(
          std::make_unique<Published<std::uint8_t>[]>(open.description.functions.size())),
      ended_(thread_->LendWakeup()) {
  if (events == Events::kTimed) outbox_.SendTimesOf(interface_);
  for (const MemberDescription& function : open.description.functions) {
    functions_.push_back(std::make_unique<FunctionProxy>(interface_, function));
    function_names_.push_back(function.name);
  }
  std::uint32_t handle = handle_;
  for (const MemberDescription& handler : open.description.event_handlers) {
    auto offer = std::make_unique<QueuedOfferProxy>(handler, outbox_, ++handle);
    offer->SetOverflow(OverflowOf(latest_only, handler.name));
    handlers_.push_back(offer.get());
    interface_.AddOffer(std::move(offer));
  }
  interface_.SetMailboxCapacity(capacity_);
  interface_.Seal();
}

bool RequiredInterfaceProxy::BeginCredit(const Connection& connection, Server server) {
  const std::scoped_lock lock(mutex_);
  connection_ = &connection;
  server_ = std::move(server);
  told_.accepting = IsAccepting();
  return told_.accepting;
}

/// By whoever executes: a task, or the threads that call, where the component has none.
bool RequiredInterfaceProxy::IsAccepting() const {
  if (const Inbox* inbox = server_.interface->inbox()) return inbox->accepting();
  const Host* host = server_.interface->host();
  return host == nullptr || host->accepting();
}

/// No longer than catalogues take it: an exception may say anything.
std::string RequiredInterfaceProxy::Fault() const {
  const Host* host = server_.interface->host();
  return host != nullptr && host->is_faulted() ? Printable(server_.fault()) : std::string();
}

/// Whether the server is another than the peer was told, but for what it has executed.
bool RequiredInterfaceProxy::IsChanged() const {
  return IsAccepting() != told_.accepting || Fault() != told_.fault;
}

void RequiredInterfaceProxy::EndCredit() {
  const std::scoped_lock waiting(waiting_);  // what is waited for there must not be freed
  const std::scoped_lock lock(mutex_);
  begun_.GiveUp();
  connection_ = nullptr;
  server_ = {};
}

void RequiredInterfaceProxy::OnCommand(std::size_t function, std::span<const std::byte> argument) {
  if (function >= functions_.size() || !IsQueued(functions_[function]->kind())) return;
  (void)(*functions_[function])(argument, answer_);  // a refused one counts as executed
  CountReceived(Watch::kClosely);
}

void RequiredInterfaceProxy::CountReceived(Watch watch) {
  std::unique_lock lock(mutex_);
  ++received_;
  if (watch_ >= watch) return;
  if (watch == Watch::kNowAndThen) owed_since_ = SteadyClock().Now();
  watch_ = watch;
  lock.unlock();
  thread_->Notify();
}

void RequiredInterfaceProxy::OnRead(std::size_t function, std::span<const std::byte> argument,
                                    Responder responder) {
  if (function >= functions_.size() || CanBeAwaited(functions_[function]->kind())) {
    return responder.Refuse({ErrorCode::kInvalid, "no such read in " + interface_.name()});
  }
  const LargeInHand mark;  // how large the answer is, is known once it is there
  const auto can_be_sent = [&](std::size_t size) { return CanBeSent(function, size); };
  ReadReply reply(std::move(responder), can_be_sent, answer_);
  reply.Finish((*functions_[function])(argument, reply));
}

bool RequiredInterfaceProxy::CanBeSent(std::size_t function, std::size_t size) {
  if (size <= kMaxPayload) return true;
  outbox_.refused_payloads().Log(function_names_[function], size);
  return false;
}

void RequiredInterfaceProxy::OnWait(std::size_t function, std::span<const std::byte> question,
                                    Responder responder) {
  const auto timeout = TakeTimeout(question);
  if (!timeout || function >= functions_.size() || !CanBeAwaited(functions_[function]->kind())) {
    return responder.Refuse({ErrorCode::kInvalid, "no such command in " + interface_.name()});
  }
  const Waiter waiter(responder.is_asked_here() && IsQuick(function));
  const SteadyTime now = SteadyClock().Now();
  BegunCalls::Begun begun{.since = now,
                          .deadline = now + *timeout,
                          .is_told = !waiter.waits(),
                          .function = function,
                          .responder = std::move(responder)};
  std::unique_lock waiting(waiting_, std::defer_lock);
  if (!begun.is_told) waiting.lock();
  const Status status = functions_[function]->Begin(
      question, answer_, begun.is_told ? thread_->wakeup() : *ended_, begun.command, begun.call);
  const bool is_queued = status == Status(Status::kQueued);
  const bool answer_tells =
      is_queued && !begun.is_told && channel_->protocol_version() >= message::kAnswersTellCredit;
  CountReceived(answer_tells ? Watch::kNowAndThen : Watch::kClosely);
  if (!is_queued) return OnEnd(begun, status, answer_, now);
  Await(std::move(begun));
}

bool RequiredInterfaceProxy::IsQuick(std::size_t function) const {
  return quick_in_a_row_[function].Get() >= kQuickInARow;
}

/// Of one call. Two that end at once may count as one.
void RequiredInterfaceProxy::NoteTime(std::size_t function, std::chrono::nanoseconds took) {
  Published<std::uint8_t>& quick = quick_in_a_row_[function];
  const std::uint8_t before = quick.Get();
  quick.Set(took > kSoon ? 0 : std::min<std::uint8_t>(before + 1, kQuickInARow));
}

/// What is not over soon is left to the network thread.
void RequiredInterfaceProxy::Await(BegunCalls::Begun begun) {
  std::unique_lock lock(mutex_);
  // Closed meanwhile: it is executed, or it is dropped.
  if (connection_ == nullptr) return OnEnd(begun, Status::kOutcomeUnknown, answer_, begun.since);
  bool has_ended = false;
  if (!begun.is_told) {
    lock.unlock();  // and waiting_ is locked: it is not closed before this is over
    has_ended = ended_->WaitUntil([&begun] { return begun.command->HasEnded(begun.call); },
                                  begun.since + kPatience);
    lock.lock();
  }
  begun_.Add(std::move(begun));
  if (has_ended) {
    SteadyTime next;
    begun_.Answer(SteadyClock().Now(), next);
    if (!IsChanged()) return;
  }
  watch_ = Watch::kClosely;
  lock.unlock();
  thread_->Notify();
}

void RequiredInterfaceProxy::OnEnd(BegunCalls::Begun& begun, Status status, Bytes& result,
                                   SteadyTime now) {
  NoteTime(begun.function, now - begun.since);
  if (!CanBeSent(begun.function, result.size())) status = Status::kFailed;
  if (!status) result.clear();
  AppendStatus(status, result);
  begun.responder.Reply(result, kOwnLane);
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
  loss_report_.Tell(now, next);
  return sent > 0;
}

/// Whether the peer must hear it now; what was executed may wait for more, unless that is half of
/// what the peer may have under way, and no answers have told it.
bool RequiredInterfaceProxy::IsUrgent(const message::Credit& credit) const {
  if (credit.accepting != told_.accepting || credit.fault != told_.fault) return true;
  return watch_ != Watch::kNowAndThen && 2 * (credit.executed - told_.executed) >= capacity_;
}

/// A peer whose caller has left has not learnt from the answer what that told; so it is told now
/// and then all the same.
void RequiredInterfaceProxy::SendCredit(SteadyTime now, SteadyTime& next) {
  constexpr std::chrono::milliseconds kLatest(4);
  constexpr std::chrono::milliseconds kLatestBehindAnswers(100);
  constexpr std::chrono::milliseconds kUntilNextLook(1);
  const std::scoped_lock lock(mutex_);
  if (connection_ == nullptr) return;
  begun_.Answer(now, next);
  // In this order: what is posted meanwhile makes it too small, never too large.
  const std::uint64_t received = received_;
  const std::uint64_t executed =
      received - std::min<std::uint64_t>(connection_->waiting(), received);
  const message::Credit credit{
      .executed = std::max(executed, told_.executed), .accepting = IsAccepting(), .fault = Fault()};
  const bool is_close = watch_ != Watch::kNowAndThen;
  const auto latest = is_close ? kLatest : kLatestBehindAnswers;
  if (credit == told_) {
    owed_since_ = now;
  } else if (IsUrgent(credit) || now - owed_since_ >= latest) {
    if (channel_->Notify(message::kCredit, handle_, credit)) told_ = credit;
  }
  if (told_.executed == received && credit == told_) {
    watch_ = Watch::kNone;
    return;
  }
  if (watch_ == Watch::kNone) watch_ = Watch::kClosely;
  const bool is_later = watch_ == Watch::kNowAndThen && now - owed_since_ < kLatestBehindAnswers;
  next = std::min(next, is_later ? owed_since_ + kLatestBehindAnswers : now + kUntilNextLook);
}

}  // namespace tendon
