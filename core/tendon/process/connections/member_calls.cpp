#include <tendon/process/connections/member_calls.h>

#include <tendon/proxy/executing_calls.h>

#include <utility>
#include <vector>

namespace tendon {

/// One command, ready to be called. A read needs no mailbox or connection.
class MemberCalls::Target : public std::enable_shared_from_this<Target>,
                            private ExecutingCalls::Owner {
 public:
  /// `executor` executes the calls of this command. It may be null if no call runs component code
  /// in the caller's thread.
  Target(const Offer& offer, ProvidedInterface& provided, const std::string& name,
         std::shared_ptr<SerialExecutor> executor)
      : description_(offer.description()),
        interface_(name),
        enabled_(offer.enabled()),
        executor_(std::move(executor)),
        required_("call", nullptr) {
    if (!CanBeAwaited(description_.signature.kind)) {
      read_ = offer.Bind(nullptr);
      return;
    }
    function_ = std::make_unique<FunctionProxy>(required_, description_);
    auto connection = Connection::Make(required_, provided, "call", name);
    if (connection) connection_ = *std::move(connection);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  ~Target() override { Close(); }

  /// Executes the call and replies. Another thread does this if it may take long. Any thread.
  void Call(const std::shared_ptr<message::CallMember>& call, NetworkThread& network,
            const std::shared_ptr<Responder>& responder) {
    const auto execute = [self = shared_from_this(), call, &network, responder,
                          deadline = DeadlineAfter(call->timeout)] {
      self->Execute(call->argument, deadline, network, std::move(*responder));
    };
    if (!executor_) return execute();
    if (executor_->Post(execute, call->argument.size())) return;
    responder->Refuse({ErrorCode::kFailed, "too many calls of '" + description_.name + "' of " +
                                               interface_ + " are waiting: try again later"});
  }

  /// Network thread: replies to the calls that have ended.
  void SendReplies(SteadyTime now, SteadyTime& next) {
    const std::scoped_lock lock(begun_mutex_);
    begun_.SendReplies(now, next);
  }

  /// Disconnects the command. After this function has returned, the component is not used any more.
  void Close() {
    is_closed_.Set(true);  // threads that wait for mutex_ check it and stop
    const std::scoped_lock lock(mutex_);
    {
      const std::scoped_lock begun_lock(begun_mutex_);
      begun_.GiveUp();
    }
    read_.reset();
    connection_.reset();
  }

 private:
  /// Executes the call and replies. If the call must wait, SendReplies() replies later in the
  /// network thread.
  void Execute(std::span<const std::byte> argument, SteadyTime deadline, NetworkThread& network,
               Responder responder) {
    if (is_closed_.Get()) return Finish(Status::kNotConnected, {}, responder);
    const bool is_late = executor_ && SteadyClock().Now() >= deadline;
    if (is_late) return Finish(Status::kTimeout, {}, responder);
    const std::scoped_lock lock(mutex_);
    static const Bytes nothing = EncodeBody(None{});
    if (argument.empty() && description_.signature.in == FingerprintOf<None>()) argument = nothing;
    Bytes result;
    CommandBase* command = nullptr;
    std::size_t call = 0;
    const Status status = Begin(argument, result, network, command, call);
    if (command == nullptr || status != Status(Status::kQueued)) {
      return Finish(status, result, responder);
    }
    {
      const std::scoped_lock begun_lock(begun_mutex_);
      begun_.Add({.command = command,
                  .call = call,
                  .since = SteadyClock().Now(),
                  .deadline = deadline,
                  .responder = std::move(responder)});
    }
    network.Notify();
  }

  void OnEnd(ExecutingCalls::ExecutingCall& begun, Status status, Bytes& result) override {
    Finish(status, result, begun.responder);
  }

  void Finish(Status status, const Bytes& result, Responder& responder) const {
    if (result.size() > kMaxPayload) {
      const std::string what = "the result of '" + description_.name + "'";
      return responder.Refuse(ExceedsMaxPayload(what, result.size(), interface_));
    }
    const bool has_result = description_.signature.out != FingerprintOf<None>();
    message::CallMemberReply called{.status = static_cast<std::uint8_t>(status.code()),
                                    .result = {}};
    if (status && has_result) called.result = result;
    responder.Reply(EncodeBody(called), kOwnLane);
  }

  /// Begins the call. Sets `command` if the caller must wait for the component.
  Status Begin(std::span<const std::byte> argument, Bytes& result, NetworkThread& network,
               CommandBase*& command, std::size_t& call) {
    if (read_) {
      BytesSink sink(result);
      return enabled_.Get() ? read_->ExecuteEncoded(argument, sink) : Status(Status::kDisabled);
    }
    if (!function_) return Status::kNotConnected;
    if (IsQueued(function_->kind())) return (*function_)(argument, result);
    return function_->Begin(argument, result, network.wakeup(), command, call);
  }

  const MemberDescription description_;
  const std::string interface_;
  const Flag& enabled_;  // belongs to the component
  const std::shared_ptr<SerialExecutor> executor_;
  Flag is_closed_;
  std::mutex mutex_;
  std::unique_ptr<CommandBase> read_;
  RequiredInterface required_;
  std::unique_ptr<FunctionProxy> function_;
  std::unique_ptr<Connection> connection_;
  std::mutex begun_mutex_;  // locked after mutex_, which is held while component code runs
  ExecutingCalls begun_{*this};
};

void MemberCalls::Call(const std::shared_ptr<message::CallMember>& call,
                       const std::shared_ptr<Responder>& responder) {
  if (const auto target = Find(KeyOf(*call))) {
    return target->Call(call, *context_.network, responder);
  }
  context_.worker->Post([this, call, responder] {
    const auto target = Make(*call);
    if (!target) return responder->Refuse(target.error());
    (*target)->Call(call, *context_.network, responder);
  });
}

void MemberCalls::RemoveComponent(const std::string& component) {
  std::vector<std::shared_ptr<Target>> removed;
  {
    const std::scoped_lock lock(mutex_);
    for (auto target = targets_.begin(); target != targets_.end();) {
      if (std::get<0>(target->first) != component) {
        ++target;
        continue;
      }
      removed.push_back(target->second);
      target = targets_.erase(target);
    }
  }
  for (const auto& target : removed) target->Close();
}

std::shared_ptr<MemberCalls::Target> MemberCalls::Find(const Key& key) {
  const std::scoped_lock lock(mutex_);
  const auto found = targets_.find(key);
  return found == targets_.end() ? nullptr : found->second;
}

/// Finds or makes the target of a call. Called on the worker.
Result<std::shared_ptr<MemberCalls::Target>> MemberCalls::Make(const message::CallMember& call) {
  const auto structure = context_.process.LockStructure();
  if (auto target = Find(KeyOf(call))) return target;
  const InterfaceName name(context_.name, call.component, call.interface);
  const auto provided = context_.process.LookUpProvided(name);
  if (!provided) return provided.error();
  const Offer* offer = (*provided)->FindCommand(call.member);
  if (offer == nullptr) {
    std::vector<std::string> known;
    for (const auto& command : (*provided)->description().commands) known.push_back(command.name);
    return Error{ErrorCode::kNotFound, ToString(name) + " has no command '" + call.member + "'" +
                                           DidYouMean(call.member, known)};
  }
  if (!offer->refusal().empty()) {
    return Error{ErrorCode::kFailed,
                 ToString(name) + "." + call.member + " is refused: " + offer->refusal()};
  }
  auto target = std::make_shared<Target>(*offer, **provided, ToString(name),
                                         ExecutorFor(*offer, **provided, call));
  const std::scoped_lock lock(mutex_);
  targets_[KeyOf(call)] = target;
  return target;
}

/// Returns the executor for the commands of one interface, which keeps their order. Returns null if
/// no executor is needed.
std::shared_ptr<SerialExecutor> MemberCalls::ExecutorFor(const Offer& offer,
                                                         const ProvidedInterface& provided,
                                                         const message::CallMember& call) {
  constexpr std::size_t kMaxCalls = 64;
  constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;
  if (!offer.RunsInCaller(provided.inbox() != nullptr)) return nullptr;
  if (!CanBeAwaited(offer.description().signature.kind)) {
    return context_.calls->reads.MakeExecutor(kMaxCalls, kMaxBytes);
  }
  auto& executor = commands_[{call.component, call.interface}];
  if (!executor) executor = context_.calls->commands.MakeExecutor(kMaxCalls, kMaxBytes);
  return executor;
}

bool MemberCalls::Work(SteadyTime now, SteadyTime& next) {
  const std::scoped_lock lock(mutex_);
  for (const auto& [key, target] : targets_) target->SendReplies(now, next);
  return false;
}

}  // namespace tendon
