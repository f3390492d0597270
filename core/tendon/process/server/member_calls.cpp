#include <tendon/process/server/member_calls.h>

#include <utility>
#include <vector>

namespace tendon {

/// One command, ready to be called. A read has no mailbox and is bound alone.
class MemberCalls::Target {
 public:
  Target(const Offer& offer, ProvidedInterface& provided, const std::string& name)
      : description_(offer.description()), enabled_(offer.enabled()), required_("call", nullptr) {
    if (!IsQueued(description_.signature.kind)) {
      read_ = offer.Bind(nullptr);
      return;
    }
    function_ = std::make_unique<FunctionProxy>(required_, description_);
    auto connection = Connection::Make(required_, provided, "call", name);
    if (connection) connection_ = *std::move(connection);
  }

  /// Any thread, one after the other.
  message::Called Execute(std::span<const std::byte> argument) {
    const std::scoped_lock lock(mutex_);
    static const Bytes nothing = EncodeBody(None{});
    if (argument.empty() && description_.signature.in == FingerprintOf<None>()) argument = nothing;
    message::Called called;
    Status status = Status::kNotConnected;
    if (read_) {
      status = enabled_.Get() ? read_->ExecuteEncoded(argument, called.answer)
                              : Status(Status::kDisabled);
    } else if (function_) {
      status = (*function_)(argument, called.answer);
    }
    called.status = static_cast<std::uint8_t>(status.code());
    if (!status || description_.signature.out == FingerprintOf<None>()) called.answer.clear();
    return called;
  }

  /// Afterwards nothing of the component is touched.
  void Close() {
    const std::scoped_lock lock(mutex_);
    read_.reset();
    connection_.reset();
  }

 private:
  const MemberDescription description_;
  const Flag& enabled_;  // of the component
  std::mutex mutex_;
  std::unique_ptr<CommandBase> read_;
  RequiredInterface required_;
  std::unique_ptr<FunctionProxy> function_;
  std::unique_ptr<Connection> connection_;
};

void MemberCalls::Call(const std::shared_ptr<message::CallMember>& call,
                       const std::shared_ptr<Responder>& responder) {
  if (const auto target = Find(KeyOf(*call))) {
    return responder->Answer(Result(target->Execute(call->argument)));
  }
  context_.worker->Post([this, call, responder] {
    const auto target = Make(*call);
    if (!target) return responder->Refuse(target.error());
    responder->Answer(Result((*target)->Execute(call->argument)));
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

/// On the worker.
Result<std::shared_ptr<MemberCalls::Target>> MemberCalls::Make(const message::CallMember& call) {
  const auto structure = context_.host.LockStructure();
  if (auto target = Find(KeyOf(call))) return target;
  const InterfaceName name(context_.name, call.component, call.interface);
  const auto provided = context_.host.LookUpProvided(name);
  if (!provided) return provided.error();
  const Offer* offer = (*provided)->FindCommand(call.member);
  if (offer == nullptr) {
    std::vector<std::string> known;
    for (const auto& command : (*provided)->description().commands) known.push_back(command.name);
    return Error{ErrorCode::kNotFound, ToString(name) + " has no command '" + call.member + "'" +
                                           DidYouMean(call.member, known)};
  }
  const CommandKind kind = offer->description().signature.kind;
  if (WaitsForServer(kind)) {
    return Error{ErrorCode::kInvalid, "'" + call.member + "' of " + ToString(name) + " is a " +
                                          std::string(ToString(kind)) +
                                          " command; those are called within its process only"};
  }
  auto target = std::make_shared<Target>(*offer, **provided, ToString(name));
  const std::scoped_lock lock(mutex_);
  targets_[KeyOf(call)] = target;
  return target;
}

}  // namespace tendon
