#include <tendon/process/process.h>

#include <tendon/base/os/process.h>
#include <tendon/middleware/tcp.h>
#include <tendon/process/connections/peer_session.h>
#include <tendon/process/connections/remote_connections.h>
#include <tendon/process/context.h>
#include <tendon/process/history/process_history.h>
#include <tendon/process/lifecycle/lifecycle_executor.h>
#include <tendon/process/local_access.h>
#include <tendon/process/membership/advertised_address.h>
#include <tendon/process/membership/membership.h>
#include <tendon/proxy/component_proxy.h>

#include <future>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

namespace tendon {
namespace {

InterfaceName WithoutProcess(const InterfaceName& name) { return {name.component, name.interface}; }

/// Returns the address of the GCM. If `address` is only a host, adds the GCM's default port.
std::string GcmAddress(const std::string& address) {
  const bool is_host = address.find(':') == std::string::npos || address.ends_with(']');
  return is_host ? address + ":" + std::to_string(kDefaultGcmPort) : address;
}

Hello MakeHello(const std::string& name) {
  const auto cookie = LoopbackCookie();
  if (!cookie) throw ConfigurationError(cookie.error());
  return {.instance = os::RandomNumber(), .name = name, .session = 0, .cookie = *cookie};
}

}  // namespace

/// The network parts of a process.
class Process::Parts final : private ProcessAccess, public MembershipDelegate {
 public:
  Parts(Process& process, const std::string& name, const ProcessOptions& options)
      : process_(process),
        network_(std::make_shared<NetworkThread>()),
        context_{.name = name,
                 .process = *this,
                 .middleware = options.middleware,
                 .hello = MakeHello(name),
                 .worker = std::make_shared<Worker>("process", name),
                 .opener = std::make_shared<Worker>("opener", name),
                 .gcm_opener = std::make_shared<Worker>("gcm opener", name),
                 .network = network_,
                 .calls = std::make_shared<CallExecutors>(),
                 .proxies = ComponentProxies(network_)},
        history_(name, options.history),
        services_{.context = context_,
                  .history = history_,
                  .connections = ServedConnections(context_),
                  .calls = MemberCalls(context_),
                  .telemetry = TelemetryServer(context_, history_)},
        connections_(context_),
        lifecycle_({.manager = process, .process = name, .loader = options.loader}) {}

  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  /// Starts to listen and to join the GCM. Call it after the constructor of Process has set its
  /// parts.
  void Open(const ProcessOptions& options) {
    Listen(options);
    if (options.gcm.empty()) return;
    membership_ = std::make_unique<Membership>(context_, *this,
                                               Membership::Options{.gcm = GcmAddress(options.gcm),
                                                                   .retry = options.retry,
                                                                   .process = Description(),
                                                                   .listens = listener_->address(),
                                                                   .advertise = options.advertise});
    membership_->Begin();
  }

  void WatchPlugins() {
    lifecycle_.WatchPlugins([this] { OnChanged(); });
  }

  /// Refuses orders from the GCM from now on.
  void RefuseOrders() { lifecycle_.Close(); }

  [[nodiscard]] bool HasCallsUnderWay(const Component& client) const {
    return connections_.HasCallsUnderWay(client.name());
  }

  /// Leaves the GCM and closes all connections. Drops unfinished calls at `deadline`. Call it
  /// before the process destroys its parts.
  void Close(SteadyTime deadline) {
    lifecycle_.Stop();  // before the worker stops, because Stop() may wait for tasks of the worker
    context_.opener->Stop();
    context_.gcm_opener->Stop();
    context_.worker->Stop();  // after this, only this thread changes connections
    if (membership_) membership_->Leave();
    connections_.Close(deadline);
    listener_.reset();
    if (local_access_) local_access_->Close();
    services_.connections.Close(deadline);
  }

  [[nodiscard]] const ProcessContext& context() const { return context_; }
  [[nodiscard]] std::string address() const {
    const std::scoped_lock lock(address_mutex_);
    return address_;
  }
  [[nodiscard]] const Membership* membership() const { return membership_.get(); }
  [[nodiscard]] RemoteConnections& connections() { return connections_; }

  [[nodiscard]] ProcessHistory& history() { return history_; }

  void ForwardLog(LogLevel level, std::string_view source, std::string_view text) {
    history_.AddLog(level, source, text);
    if (membership_) membership_->ForwardLog(level, source, text);
  }

  [[nodiscard]] bool HasSentAll() {
    return services_.telemetry.HasSentAll() && services_.connections.HasSentAllEvents();
  }

  void OnChanged() {
    if (membership_) membership_->ReportSoon();
    network_->Notify();
    history_.Wake();
  }

  Result<ConnectionId> Connect(const message::ConnectionEnds& ends) {
    const auto promise = std::make_shared<std::promise<Result<ConnectionId>>>();
    context_.worker->Post([this, ends, promise] {
      connections_.Connect(ends, [promise](const auto& made) {
        promise->set_value(made ? Result<ConnectionId>(made->id) : made.error());
      });
    });
    return promise->get_future().get();
  }

  /// If the GCM has ordered this connection, returns its id, and makes the program its owner.
  [[nodiscard]] std::optional<ConnectionId> TakeOver(const message::ConnectionEnds& ends) {
    const auto lock = process_.Lock();
    const auto connection = ConnectionOf(ends.required);
    const bool is_it = connection && connection->provided == ends.provided &&
                       connection->state != ConnectionState::kFailed;
    if (!is_it || std::erase(ordered_, ends) == 0) return {};
    return connection->id;
  }

  std::shared_ptr<LocalAccess> OpenLocalAccess() {
    const auto lock = process_.Lock();
    if (local_access_) return local_access_;
    auto access = std::make_shared<LocalAccess>(context_.name, context_.hello.instance,
                                                [this](ProcessContent& content) {
                                                  const auto held = process_.TryLock();
                                                  if (held.owns_lock()) content = this->content();
                                                  return held.owns_lock();
                                                });
    const auto choose = [this] { return std::make_shared<PeerSession>(services_); };
    const Hello hello{.instance = context_.hello.instance,
                      .name = context_.name,
                      .session = 0,
                      .cookie = context_.hello.cookie};
    const auto listens = access->Listen(Channel::Acceptor(hello, choose));
    if (!listens) throw ConfigurationError(listens.error());
    local_access_ = std::move(access);
    return local_access_;
  }

  void ForgetOrder(const InterfaceName& required) {
    const auto lock = process_.Lock();
    std::erase_if(ordered_,
                  [&](const message::ConnectionEnds& ends) { return ends.required == required; });
  }

  void RemoveComponent(const std::string& component) {
    connections_.RemoveComponent(component);
    services_.connections.RemoveComponent(component);
    services_.calls.RemoveComponent(component);
    services_.telemetry.RemoveComponent(component);
  }

 private:
  void Listen(const ProcessOptions& options) {
    const auto choose = [this] { return std::make_shared<PeerSession>(services_); };
    auto listener =
        context_.middleware->Listen(options.listen, Channel::Acceptor(context_.hello, choose));
    if (!listener) throw ConfigurationError(listener.error());
    listener_ = *std::move(listener);
    address_ = AdvertisedAddressOf(listener_->address(), options.advertise, {}).address;
  }

  std::unique_lock<std::recursive_mutex> LockStructure() const override { return process_.Lock(); }
  Result<RequiredInterface*> LookUpRequired(const InterfaceName& name) const override {
    return process_.FindRequired(name);
  }
  Result<ProvidedInterface*> LookUpProvided(const InterfaceName& name) const override {
    return process_.FindProvided(name);
  }
  Component* LookUpComponent(const std::string& component) const override {
    return process_.Find(component);
  }
  Result<ConnectionCounts> LookUpCounts(const InterfaceName& required) const override {
    const std::string& own = context_.name;
    if (required.process.empty() || required.process == own) return process_.Counts(required);
    for (const ComponentProxy& client : context_.proxies.all()) {
      if (client.process != required.process || client.component != required.component) continue;
      for (const auto& proxy : client.required) {
        if (proxy->interface().name() != required.interface) continue;
        return ConnectionCounts{.capacity = proxy->capacity(), .lost_events = proxy->lost_events()};
      }
    }
    return Error{ErrorCode::kNotFound,
                 "process '" + own + "' has no connection from " + ToString(required)};
  }
  Result<MailboxFill> LookUpFill(const std::string& component) const override {
    return process_.FillOf(component);
  }
  ConnectionId NewConnectionId() override { return process_.NextConnectionId(); }
  void StructureChanged() const override { process_.NotifyChanged(); }

  [[nodiscard]] ProcessDescription Description() const {
    ProcessDescription description;
    description.name = context_.name;
    description.instance = context_.hello.instance;
    description.host = os::HostName();
    description.pid = os::ProcessId();
    return description;
  }

  ProcessContent content() const override {
    const auto lock = process_.Lock();
    return {.components = process_.components(),
            .connections = process_.connections(),
            .plugins = lifecycle_.plugins()};
  }

  [[nodiscard]] std::optional<ConnectionDescription> ConnectionOf(
      const InterfaceName& required) const {
    for (const ConnectionDescription& connection : process_.connections()) {
      if (connection.required == required) return connection;
    }
    return {};
  }

  void OnOwnAddress(const std::string& address) override {
    const std::scoped_lock lock(address_mutex_);
    address_ = address;
  }

  void OnPeers(const std::vector<ProcessDescription>& processes) override {
    connections_.UpdatePeers(processes);
  }

  void OnBroker(const std::string& address) override { services_.telemetry.SetBroker(address); }

  void MakeConnection(const message::ConnectionPlan& plan, RemoteConnections::Done done) override {
    const message::ConnectionEnds& ends = plan.ends;
    const auto here = process_.Here(ends.required);
    if (!here) return done(here.error());
    {
      const auto lock = process_.Lock();
      if (!ConnectionOf(ends.required)) {
        ForgetOrder(ends.required);
        ordered_.push_back(ends);
      }
    }
    if (ends.provided.process != context_.name) {
      connections_.LearnPeer(ends.provided.process, plan.address, plan.instance);
      return connections_.Connect(ends, [this, ends, done](const auto& made) {
        if (!made) ForgetOrder(ends.required);
        done(made);
      });
    }
    const auto id = process_.ConnectAnew(ends.required, ends.provided);
    if (!id) {
      ForgetOrder(ends.required);
      return done(id.error());
    }
    done(ConnectionDescription{.id = *id,
                               .required = ends.required,
                               .provided = ends.provided,
                               .state = ConnectionState::kActive,
                               .reason = {}});
  }

  Result<void> BreakConnection(const InterfaceName& required) override {
    return process_.Disconnect(required);
  }

  void ExecuteOrder(const message::LifecycleOrder& order, std::function<Result<void>()> begin,
                    std::function<void(const Result<message::LifecycleOutcome>&)> done) override {
    lifecycle_.ExecuteOrder(order, std::move(begin), OnWorker(std::move(done)));
  }

  void ListClasses(std::function<void(const Result<message::Classes>&)> done) override {
    lifecycle_.ListClasses(OnWorker(std::move(done)));
  }

  /// Returns a function that calls `done` on the worker.
  template <typename T>
  LifecycleExecutor::Done<T> OnWorker(std::function<void(const Result<T>&)> done) {
    return [&worker = *context_.worker, done = std::move(done)](const Result<T>& result) {
      worker.Post([done, result] { done(result); });
    };
  }

  Process& process_;
  const std::shared_ptr<NetworkThread> network_;
  ProcessContext context_;
  ProcessHistory history_;
  Services services_;
  RemoteConnections connections_;
  LifecycleExecutor lifecycle_;
  // The connections that only the GCM has ordered, not the program. Protected by the manager's
  // lock.
  std::vector<message::ConnectionEnds> ordered_;
  mutable std::mutex address_mutex_;
  std::string address_;  // the announced address
  std::unique_ptr<Membership> membership_;
  std::unique_ptr<Listener> listener_;
  std::shared_ptr<LocalAccess> local_access_;  // made on demand
};

Process::Process(std::string name, ProcessOptions options) {
  RequireName("process", name);
  if (!options.advertise.empty()) {
    if (const auto checked = CheckAdvertise(options.advertise); !checked) {
      throw ConfigurationError(checked.error());
    }
  }
  if (!options.middleware) {
    throw ConfigurationError("process '" + name + "' has no middleware; see Tcp() and Ice()");
  }
  parts_ = std::make_unique<Parts>(*this, name, options);
  try {
    parts_->Open(options);
    SetObserver([parts = parts_.get()] { parts->OnChanged(); });
    parts_->WatchPlugins();
  } catch (...) {  // the parts have threads, which must end before the parts are destroyed
    SetObserver(nullptr);
    parts_->Close(SteadyClock().Now());
    throw;
  }
}

Process::~Process() {
  SetObserver(nullptr);
  const SteadyTime deadline = SteadyClock().Now() + kEndTimeout;
  parts_->RefuseOrders();
  EndAll(deadline);
  parts_->Close(deadline);
  parts_.reset();
  Clear();
}

bool Process::HasCallsUnderWay(const Component& client) const {
  return LocalManager::HasCallsUnderWay(client) || parts_->HasCallsUnderWay(client);
}

const std::string& Process::name() const { return parts_->context().name; }

std::string Process::address() const { return parts_->address(); }

std::uint64_t Process::instance() const { return parts_->context().hello.instance; }

Result<void> Process::WaitUntilJoined(std::chrono::milliseconds timeout) const {
  if (parts_->membership() != nullptr) return parts_->membership()->WaitUntilJoined(timeout);
  return Error{ErrorCode::kFailed,
               "process '" + name() + "' has no GCM to join; set one in its options"};
}

bool Process::is_joined() const {
  return parts_->membership() != nullptr && parts_->membership()->is_joined();
}

bool Process::HasSentAll() const { return parts_->HasSentAll(); }

void Process::ForwardLog(LogLevel level, std::string_view source, std::string_view text) {
  parts_->ForwardLog(level, source, text);
}

Result<ConnectionId> Process::Connect(const InterfaceName& required,
                                      const InterfaceName& provided) {
  const auto here = Here(required);
  if (!here) return here.error();
  const InterfaceName there = Full(provided);
  auto made = ConnectAnew(*here, there);
  if (made) parts_->ForgetOrder(*here);
  if (made || made.error().code != ErrorCode::kExists) return made;
  const auto ordered = parts_->TakeOver({.required = *here, .provided = there});
  return ordered ? Result<ConnectionId>(*ordered) : made;
}

Result<ConnectionId> Process::ConnectAnew(const InterfaceName& required,
                                          const InterfaceName& provided) {
  if (provided.process != name()) {
    return parts_->Connect({.required = required, .provided = provided});
  }
  if (parts_->connections().Has(required)) return AlreadyConnected(ToString(required));
  return LocalManager::Connect(WithoutProcess(required), WithoutProcess(provided));
}

Result<void> Process::Disconnect(const InterfaceName& required) {
  const auto here = Here(required);
  if (!here) return here.error();
  if (parts_->connections().Has(*here)) return parts_->connections().Disconnect(*here);
  return LocalManager::Disconnect(WithoutProcess(*here));
}

Result<ConnectionCounts> Process::Counts(const InterfaceName& required) const {
  const auto here = Here(required);
  if (!here) return here.error();
  const auto lock = Lock();
  if (parts_->connections().Has(*here)) return parts_->connections().Counts(*here);
  return LocalManager::Counts(WithoutProcess(*here));
}

std::vector<ConnectionDescription> Process::connections() const {
  const auto lock = Lock();
  std::vector<ConnectionDescription> all = LocalManager::connections();
  for (ConnectionDescription& connection : all) {
    connection.required = Full(connection.required);
    connection.provided = Full(connection.provided);
  }
  const auto remote = parts_->connections().descriptions();
  all.insert(all.end(), remote.begin(), remote.end());
  return all;
}

std::vector<ComponentProxy> Process::proxies() const { return parts_->context().proxies.all(); }

std::shared_ptr<LocalAccess> Process::OpenLocalAccess() { return parts_->OpenLocalAccess(); }

void Process::OnAttached(Component& component) { parts_->history().Add(component); }

void Process::OnDetached(const Component& component) { parts_->history().Remove(component.name()); }

void Process::OnRemoving(const Component& component) { parts_->RemoveComponent(component.name()); }

InterfaceName Process::Full(InterfaceName interface) const {
  if (interface.process.empty()) interface.process = name();
  return interface;
}

Result<InterfaceName> Process::Here(const InterfaceName& required) const {
  InterfaceName full = Full(required);
  if (full.process == name()) return full;
  return Error{
      ErrorCode::kNotFound,
      ToString(full) + " is not in process '" + name() +
          "'; connect and disconnect this interface in its own process, or through the GCM"};
}

ProcessOptions Tcp(ProcessOptions options, Exposure exposure) {
  options.middleware = MakeTcpMiddleware(exposure);
  return options;
}

}  // namespace tendon
