#include <tendon/gcm/client.h>

#include <tendon/base/os/process.h>
#include <tendon/base/path.h>
#include <tendon/gcm/client/event_feed.h>
#include <tendon/gcm/client/gcm_link.h>
#include <tendon/gcm/client/process_links.h>
#include <tendon/gcm/client/process_requests.h>
#include <tendon/gcm/conflicting_types.h>
#include <tendon/gcm/lookup.h>
#include <tendon/process/broadcast_messages.h>
#include <tendon/process/telemetry/make_telemetry_client.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace tendon {
namespace {

Result<void> Ignored(const Result<None>& result) {
  if (result) return {};
  return result.error();
}

/// Returns the description of a process, or an error if the process is gone or does not listen.
Result<ProcessDescription> FindReachable(const Catalogue& catalogue, const std::string& process) {
  const auto entry = LookUpProcess(catalogue, process);
  if (!entry) return entry.error();
  if (auto present = RequirePresent((*entry)->process); !present) return present.error();
  if ((*entry)->process.address.empty()) {
    return Error{ErrorCode::kUnreachable, "process '" + process + "' does not listen"};
  }
  return (*entry)->process;
}

/// The error for a path without a member. `path` was parsed before, so it is printable.
Error NoCommand(const std::string& path) {
  return {ErrorCode::kInvalid,
          "'" + path + "' does not name a command: expected process/component/interface.member"};
}

/// Returns the options for the links to processes. The longer the timeout of the client, the more
/// time a busy process has to accept a link.
client::ProcessLinks::Options OpeningOf(const GcmClient::Options& options) {
  client::ProcessLinks::Options opening{.name = options.name, .role = options.role};
  opening.timeout = std::max(opening.timeout, options.timeout / 2);
  return opening;
}

/// Counts pending replies. Thread-safe.
class OutstandingRequests {
 public:
  void Add() {
    const std::scoped_lock lock(mutex_);
    ++count_;
  }
  void Remove() {
    const std::scoped_lock lock(mutex_);
    if (--count_ == 0) none_.notify_all();
  }
  void WaitUntilNone(std::chrono::milliseconds timeout) {
    std::unique_lock lock(mutex_);
    none_.wait_for(lock, timeout, [this] { return count_ == 0; });
  }

 private:
  std::mutex mutex_;
  std::condition_variable none_;
  std::size_t count_ = 0;
};

/// A handler that is called exactly once. If the last copy is destroyed before the call, the
/// handler is called with an error.
template <typename T>
class OnceCallback {
 public:
  using Handler = std::function<void(Result<T>)>;

  OnceCallback(std::shared_ptr<OutstandingRequests> outstanding, Handler handler)
      : outstanding_(std::move(outstanding)), handler_(std::move(handler)) {
    outstanding_->Add();
  }
  OnceCallback(const OnceCallback&) = delete;
  OnceCallback& operator=(const OnceCallback&) = delete;
  ~OnceCallback() {
    if (handler_)
      Call(Error{ErrorCode::kUnreachable, "the request was cancelled: this program is ending"});
    outstanding_->Remove();
  }

  void Call(Result<T> result) {
    if (const Handler handler = std::exchange(handler_, nullptr)) handler(std::move(result));
  }

 private:
  const std::shared_ptr<OutstandingRequests> outstanding_;
  Handler handler_;  // empty after the call
};

/// Returns a OnceCallback as a function.
template <typename T>
std::function<void(Result<T>)> CallOnce(std::shared_ptr<OutstandingRequests> outstanding,
                                        std::function<void(Result<T>)> handler) {
  return [once = std::make_shared<OnceCallback<T>>(std::move(outstanding), std::move(handler))](
             Result<T> result) { once->Call(std::move(result)); };
}

}  // namespace

/// The parts of a client. Their order matters: they are constructed in this order and destroyed in
/// reverse order.
class GcmClient::Implementation {
 public:
  Implementation(std::shared_ptr<Middleware> middleware, const Options& options,
                 std::shared_ptr<GcmListener> listener)
      : middleware_(std::move(middleware)),
        name_(options.name),
        timeout_(options.timeout),
        link_(std::make_shared<client::GcmLink>(
            *middleware_, options,
            client::GcmLink::Events{std::move(listener),
                                    [this](const auto& processes) { OnMoved(processes); }},
            timer_)),
        links_(std::make_shared<client::ProcessLinks>(*middleware_, Resolver(link_),
                                                      OpeningOf(options))),
        requests_(std::make_shared<client::ProcessRequests>(links_, timer_, options.timeout)),
        events_(std::make_shared<client::EventFeed>(links_, timer_, EventsOf(link_), options.name,
                                                    options.timeout)) {
    links_->SetNoticeListener(events_);
    link_->Start();
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  ~Implementation() {
    constexpr std::chrono::seconds kLongest(5);
    link_->Stop();
    events_->Stop();
    links_->Stop();
    timer_->Stop();
    EndLearning();
    telemetry_.reset();
    outstanding_->WaitUntilNone(kLongest);
  }

  template <typename T>
  std::function<void(Result<T>)> Guarded(std::function<void(Result<T>)> handler) {
    return CallOnce<T>(outstanding_, std::move(handler));
  }

  /// Wraps the handler of a request to a process. Changes kUnreachable to kFailed, because
  /// kUnreachable tells a viewer that the GCM is unreachable.
  template <typename T>
  std::function<void(Result<T>)> GuardedOfProcess(std::function<void(Result<T>)> handler) {
    return [done = Guarded(std::move(handler))](Result<T> result) {
      if (result || result.error().code != ErrorCode::kUnreachable) return done(std::move(result));
      done(Error{ErrorCode::kFailed, result.error().message});
    };
  }

  client::GcmLink& link() { return *link_; }
  Worker& timer() { return *timer_; }
  client::ProcessRequests& requests() { return *requests_; }
  client::EventFeed& events() { return *events_; }
  /// Returns the telemetry client. It is created at the first call, because many programs have no
  /// subscriptions.
  TelemetryClient& telemetry() {
    const std::scoped_lock lock(mutex_);
    if (!telemetry_) {
      telemetry_ =
          MakeTelemetryClient(middleware_, AddressResolver(), Mine(), BrokerFinder(), timeout_);
    }
    return *telemetry_;
  }

  [[nodiscard]] std::chrono::milliseconds timeout() const { return timeout_; }

  void ExecuteLifecycleOrder(message::LifecycleOrder order, DoneHandler done) {
    if (order.timeout <= std::chrono::nanoseconds(0)) order.timeout = timeout_;
    if (order.instance == 0) {
      order.instance = link_->WithCatalogue([&](const Catalogue& catalogue) {
        const ProcessEntry* entry = catalogue.FindProcess(order.process);
        return entry == nullptr ? std::uint64_t{0} : entry->process.instance;
      });
    }
    const auto replied_within =
        kLifecycleOrderTimeouts * std::max<std::chrono::nanoseconds>(order.timeout, timeout_);
    const auto orders = (replied_within + timeout_ - std::chrono::nanoseconds(1)) / timeout_;
    link_->Request<None>(
        message::kLifecycleOrder, order,
        [done = std::move(done)](const auto& reply) { done(Ignored(reply)); },
        static_cast<int>(std::min<std::int64_t>(orders, 1'000'000)));
  }

  /// One check of the catalogue serves all calls since the previous check, so there are at most
  /// two checks a second.
  void LearnConflictingTypes(DoneHandler handler) {
    const std::scoped_lock lock(mutex_);
    if (closing_) return;
    learners_.push_back(std::move(handler));
    if (learners_.size() > 1) return;
    const auto pause = std::max(next_look_ - SteadyClock().Now(), SteadyTime::duration(0));
    timer_->PostAfter(std::chrono::ceil<std::chrono::milliseconds>(pause), [this] { Look(); });
  }

 private:
  using SharedLink = std::shared_ptr<client::GcmLink>;

  static client::ProcessLinks::Resolve Resolver(const SharedLink& link) {
    return [weak = std::weak_ptr(link)](const std::string& process) -> Result<ProcessDescription> {
      const auto alive = weak.lock();
      if (!alive) return Error{ErrorCode::kUnreachable, "the client is closed"};
      return alive->WithCatalogue(
          [&](const Catalogue& catalogue) { return FindReachable(catalogue, process); });
    };
  }

  static client::EventFeed::LookUp EventsOf(const SharedLink& link) {
    return [weak = std::weak_ptr(link)](
               const EventSubscription& wanted) -> Result<std::vector<MemberDescription>> {
      const auto alive = weak.lock();
      if (!alive) return Error{ErrorCode::kUnreachable, "the client is closed"};
      return alive->WithCatalogue(
          [&](const Catalogue& catalogue) { return LookUpEvents(catalogue, wanted); });
    };
  }

  [[nodiscard]] ResolveAddress AddressResolver() const {
    return [resolve = Resolver(link_)](const std::string& process) -> Result<std::string> {
      const auto there = resolve(process);
      if (!there) return there.error();
      return there->address;
    };
  }

  /// Returns a function that asks the GCM for the address of the broker at each call. The GCM
  /// answers only clients that may watch.
  [[nodiscard]] FindBroker BrokerFinder() const {
    return [weak = std::weak_ptr(link_), timeout = timeout_]() -> Result<std::string> {
      const auto alive = weak.lock();
      if (!alive) return Error{ErrorCode::kUnreachable, "the client is closed"};
      const auto place = Wait<message::BrokerAddress>(timeout, [&](auto handler) {
        alive->Request<message::BrokerAddress>(message::kGetBroker, None{}, std::move(handler));
      });
      if (!place) return place.error();
      return place->address;
    };
  }

  [[nodiscard]] Hello Mine() const {
    // If this fails, the peer refuses the link, and its error says what to do.
    const auto cookie = LoopbackCookie();
    return {.instance = os::RandomNumber(), .name = name_, .cookie = cookie ? *cookie : 0};
  }

  /// Destroys the waiting handlers. Their OnceCallbacks call them with an error.
  void EndLearning() {
    std::vector<DoneHandler> learners;
    const std::scoped_lock lock(mutex_);
    closing_ = true;
    learners.swap(learners_);
  }

  void Look() {
    constexpr std::chrono::milliseconds kPause(500);
    std::vector<DoneHandler> learners;
    {
      const std::scoped_lock lock(mutex_);
      learners.swap(learners_);
      next_look_ = SteadyClock().Now() + kPause;
    }
    const auto types = link_->WithCatalogue(&ConflictingTypes);
    requests_->Learn(types, [learners = std::move(learners)](const Result<void>& learned) {
      for (const DoneHandler& learner : learners) learner(learned);
    });
  }

  void OnMoved(const std::vector<client::GcmLink::MovedProcess>& processes) {
    for (const auto& [process, instance] : processes) {
      links_->Drop(process, instance);
      events_->Retry(process);
    }
    const std::scoped_lock lock(mutex_);
    if (!telemetry_) return;
    for (const auto& [process, instance] : processes) telemetry_->Retry(process);
  }

  /// Only this object owns the middleware. Links may be destroyed in threads of the middleware, but
  /// the middleware must not.
  const std::shared_ptr<Middleware> middleware_;
  const std::string name_;
  const std::chrono::milliseconds timeout_;
  const std::shared_ptr<OutstandingRequests> outstanding_ = std::make_shared<OutstandingRequests>();
  const std::shared_ptr<Worker> timer_ = std::make_shared<Worker>("client-timer");  // never blocked
  const SharedLink link_;
  const std::shared_ptr<client::ProcessLinks> links_;
  const std::shared_ptr<client::ProcessRequests> requests_;
  const std::shared_ptr<client::EventFeed> events_;
  std::mutex mutex_;
  std::unique_ptr<TelemetryClient> telemetry_;
  std::vector<DoneHandler> learners_;  // handlers that wait for the next check
  SteadyTime next_look_{};             // earliest time of the next check
  bool closing_ = false;
};

GcmClient::GcmClient(std::shared_ptr<Middleware> middleware, Options options,
                     std::shared_ptr<GcmListener> listener)
    : implementation_(
          std::make_unique<Implementation>(std::move(middleware), options, std::move(listener))) {}

GcmClient::~GcmClient() = default;

Result<void> GcmClient::WaitUntilWatching() { return implementation_->link().WaitUntilWatching(); }

void GcmClient::Resync() { implementation_->link().Resync(); }

void GcmClient::WithCatalogue(const std::function<void(const Catalogue&)>& read) const {
  implementation_->link().WithCatalogue(read);
}

Catalogue GcmClient::catalogue() const {
  return implementation_->link().WithCatalogue(
      [](const Catalogue& catalogue) { return catalogue; });
}

void GcmClient::Connect(const InterfaceName& required, const InterfaceName& provided,
                        ConnectHandler handler, WhenConnected when_connected) {
  const bool may_replace = when_connected == WhenConnected::kReplace;
  implementation_->link().Request<ConnectionDescription>(
      may_replace ? message::kReplace : message::kConnect,
      message::ConnectionEnds{required, provided}, implementation_->Guarded(std::move(handler)),
      may_replace ? kReplaceTimeouts : 1);
}

void GcmClient::Disconnect(const InterfaceName& required, DoneHandler handler) {
  implementation_->link().Request<None>(message::kDisconnect, message::ConnectionEnds{required, {}},
                                        [done = implementation_->Guarded(std::move(handler))](
                                            const auto& reply) { done(Ignored(reply)); });
}

void GcmClient::ExecuteLifecycleOrder(const message::LifecycleOrder& order, DoneHandler handler) {
  implementation_->ExecuteLifecycleOrder(order, implementation_->Guarded(std::move(handler)));
}

void GcmClient::ExecuteProcessOrder(message::ProcessOrder order, DoneHandler handler) {
  constexpr int kTimeoutsUntilAskedToEnd = kProcessOrderTimeouts - 2;
  if (order.timeout <= std::chrono::nanoseconds(0)) {
    order.timeout = kTimeoutsUntilAskedToEnd * implementation_->timeout();
  }
  implementation_->link().Request<None>(
      message::kProcess, order,
      [done = implementation_->Guarded(std::move(handler))](const auto& reply) {
        done(Ignored(reply));
      },
      kProcessOrderTimeouts);
}

void GcmClient::GetChildren(std::function<void(Result<message::Children>)> handler) {
  implementation_->link().Request<message::Children>(message::kGetChildren, None{},
                                                     implementation_->Guarded(std::move(handler)));
}

void GcmClient::GetClasses(const std::string& process,
                           std::function<void(Result<message::Classes>)> handler) {
  implementation_->link().Request<message::Classes>(message::kGetClasses,
                                                    message::GetClasses{process},
                                                    implementation_->Guarded(std::move(handler)));
}

void GcmClient::Undo(StepHandler handler, std::uint64_t step) {
  const message::StepSelection which{.id = step, .timeout = implementation_->timeout() * 2 / 3};
  implementation_->link().Request<message::HistoryEntry>(
      message::kUndo, which, implementation_->Guarded(std::move(handler)), kUndoTimeouts);
}

void GcmClient::SkipNewestStep(StepHandler handler, std::uint64_t step) {
  implementation_->link().Request<message::HistoryEntry>(
      message::kSkipStep, message::StepSelection{.id = step},
      implementation_->Guarded(std::move(handler)));
}

void GcmClient::TakePlanLock(DoneHandler handler) {
  implementation_->link().Request<None>(message::kPlanLock, message::PlanLock{.is_wanted = true},
                                        [done = implementation_->Guarded(std::move(handler))](
                                            const auto& reply) { done(Ignored(reply)); });
}

void GcmClient::ReleasePlanLock() {
  implementation_->link().Request<None>(message::kPlanLock, message::PlanLock{.is_wanted = false},
                                        [](const auto& /*reply*/) {});
}

void GcmClient::GetHistory(std::function<void(Result<message::History>)> handler) {
  implementation_->link().Request<message::History>(message::kHistory, None{},
                                                    implementation_->Guarded(std::move(handler)));
}

void GcmClient::GetHealth(std::function<void(Result<message::SystemHealth>)> handler) {
  implementation_->link().Request<message::SystemHealth>(
      message::kHealth, None{}, implementation_->Guarded(std::move(handler)));
}

void GcmClient::GetVersion(const std::string& process,
                           std::function<void(Result<message::ProgramVersion>)> handler) {
  if (process.empty()) {
    return implementation_->link().Request<message::ProgramVersion>(
        message::kGetProgram, None{}, implementation_->Guarded(std::move(handler)));
  }
  implementation_->timer().Post(
      [this, process, done = implementation_->GuardedOfProcess(std::move(handler))] {
        implementation_->requests().GetVersion(process, done);
      });
}

void GcmClient::GetCounts(const InterfaceName& required,
                          std::function<void(Result<ConnectionCounts>)> handler) {
  implementation_->timer().Post(
      [this, required, done = implementation_->GuardedOfProcess(std::move(handler))] {
        implementation_->requests().GetCounts(required, done);
      });
}

void GcmClient::GetProviderCounts(const message::ConnectionEnds& ends,
                                  std::function<void(Result<ConnectionCounts>)> handler) {
  implementation_->timer().Post(
      [this, ends, done = implementation_->GuardedOfProcess(std::move(handler))] {
        implementation_->requests().GetProviderCounts(ends, done);
      });
}

void GcmClient::GetFill(const std::string& process, const std::string& component,
                        std::function<void(Result<MailboxFill>)> handler) {
  implementation_->timer().Post(
      [this, process, component, done = implementation_->GuardedOfProcess(std::move(handler))] {
        implementation_->requests().GetFill(process, component, done);
      });
}

void GcmClient::GetProcessHistory(
    const std::string& process, std::function<void(Result<message::ProcessHistoryState>)> handler) {
  implementation_->timer().Post(
      [this, process, done = implementation_->GuardedOfProcess(std::move(handler))] {
        implementation_->requests().GetProcessHistory(process, done);
      });
}

void GcmClient::ReadLog(const std::string& process, const message::ReadLog& wanted,
                        std::function<void(Result<message::ReadLogReply>)> handler) {
  implementation_->timer().Post(
      [this, process, wanted, done = implementation_->GuardedOfProcess(std::move(handler))] {
        implementation_->requests().ReadLog(process, wanted, done);
      });
}

void GcmClient::Forget(const std::string& process, DoneHandler handler) {
  implementation_->link().Request<None>(message::kForget, message::ForgetProcess{process},
                                        [done = implementation_->Guarded(std::move(handler))](
                                            const auto& reply) { done(Ignored(reply)); });
}

void GcmClient::WatchLog() { implementation_->link().WatchLog(); }

void GcmClient::SetLogLevel(const std::string& process, LogLevel level, DoneHandler handler) {
  implementation_->link().Request<None>(message::kSetLogLevel, message::SetLogLevel{process, level},
                                        [done = implementation_->Guarded(std::move(handler))](
                                            const auto& reply) { done(Ignored(reply)); });
}

void GcmClient::Call(const std::string& path, const std::string& argument, TextHandler handler) {
  implementation_->timer().Post(
      [this, path, argument, done = implementation_->GuardedOfProcess(std::move(handler))] {
        const auto parsed = ParsePath(path);
        if (!parsed) return done(parsed.error());
        if (parsed->member.empty()) return done(NoCommand(path));
        const auto command = implementation_->link().WithCatalogue(
            [&](const Catalogue& catalogue) -> Result<MemberDescription> {
              auto found = LookUpCommand(catalogue, *parsed);
              if (!found) return found;
              const auto process = FindReachable(catalogue, parsed->process);
              return process ? found : Result<MemberDescription>(process.error());
            });
        if (!command) return done(command.error());
        implementation_->requests().Call(*parsed, *command, argument, done);
      });
}

void GcmClient::ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds last,
                               std::shared_ptr<EventSink> sink,
                               std::function<void(const PastEvents&)> done) {
  implementation_->events().ReadPast(events, last, std::move(sink), std::move(done));
}

GcmClient::ListenerId GcmClient::Listen(const EventSubscription& events,
                                        std::shared_ptr<EventSink> sink) {
  return implementation_->events().Listen(events, std::move(sink));
}

void GcmClient::StopListening(ListenerId id) { implementation_->events().End(id); }

void GcmClient::GetSchema(const std::string& process, Fingerprint fingerprint,
                          std::function<void(Result<Schema>)> handler) {
  implementation_->timer().Post(
      [this, process, fingerprint, done = implementation_->GuardedOfProcess(std::move(handler))] {
        implementation_->requests().GetSchema(process, fingerprint, done);
      });
}

void GcmClient::LearnConflictingTypes(DoneHandler handler) {
  implementation_->LearnConflictingTypes(implementation_->Guarded(std::move(handler)));
}

TelemetryClient& GcmClient::telemetry() { return implementation_->telemetry(); }

}  // namespace tendon
