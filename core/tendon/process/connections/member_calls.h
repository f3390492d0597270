#pragma once

#include <tendon/interface/connection.h>
#include <tendon/middleware/channel.h>
#include <tendon/process/context.h>
#include <tendon/process/viewer_messages.h>
#include <tendon/proxy/function_proxy.h>
#include <tendon/proxy/network_thread.h>

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <tuple>
#include <utility>

namespace tendon {

/// Executes any command of this process by its name, for consoles and windows. After the first call
/// of a member, the member stays connected, with its own mailbox, until its component is removed.
class MemberCalls final : private NetworkJob {
 public:
  explicit MemberCalls(ProcessContext& context) : context_(context) { context.network->Add(*this); }
  ~MemberCalls() override { context_.network->Remove(*this); }

  /// Executes a call and replies. Call it in a thread of the middleware. Replies before it returns,
  /// except to the first call of a member, and to calls that wait for the component or run
  /// component code. Refusals: kNotFound with a suggestion, kFailed if too many calls wait.
  void Call(const std::shared_ptr<message::CallMember>& call,
            const std::shared_ptr<Responder>& responder);

  /// Disconnects all members of a component. Call it before the component is removed. Any thread.
  void RemoveComponent(const std::string& component);

 private:
  class Target;
  using Key = std::tuple<std::string, std::string, std::string>;
  static Key KeyOf(const message::CallMember& call) {
    return {call.component, call.interface, call.member};
  }

  std::shared_ptr<Target> Find(const Key& key);
  Result<std::shared_ptr<Target>> Make(const message::CallMember& call);
  std::shared_ptr<SerialExecutor> ExecutorFor(const Offer& offer, const ProvidedInterface& provided,
                                              const message::CallMember& call);
  bool Work(SteadyTime now, SteadyTime& next) override;

  ProcessContext& context_;
  std::map<std::pair<std::string, std::string>, std::shared_ptr<SerialExecutor>>
      commands_;  // used on the worker
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<Target>> targets_;
};

}  // namespace tendon
