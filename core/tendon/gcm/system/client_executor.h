#pragma once

#include <tendon/gcm/client.h>
#include <tendon/gcm/system/plan_execution.h>

#include <chrono>
#include <string>

namespace tendon {

/// Executes the steps of a plan through a GCM. Refuses a step if its process was restarted, or the
/// configuration on which it is based was changed, after the plan was made. Also refuses to start a
/// component if a connection that the step needs is missing.
class ClientExecutor final : public PlanExecutor {
 public:
  /// The client must outlive the executor. `timeout` is the timeout of the client. Before a start,
  /// the executor waits up to `timeout` for the connections that the component needs.
  ClientExecutor(GcmClient& client, std::chrono::milliseconds timeout)
      : client_(client), timeout_(timeout) {}

  /// Takes the plan lock. Also succeeds if the client may not make changes (kDenied): it cannot
  /// have the lock, and each of its steps fails with a clear error.
  Result<void> Begin() override;
  /// Executes a step. Also refuses the step if the lock was lost with the link to the GCM and
  /// another viewer has it now.
  Result<void> Execute(const PlanStep& step) override;
  void End() override;

 private:
  [[nodiscard]] Result<void> TakeLock();
  [[nodiscard]] Result<void> KeepLock();
  [[nodiscard]] Result<void> CheckInstance(const PlanStep& step) const;
  [[nodiscard]] Result<void> AwaitConnections(const PlanStep& step) const;
  Result<void> Connect(const PlanStep& step);
  [[nodiscard]] bool IsMadeByOthers(const message::ConnectionEnds& ends, ErrorCode refusal) const;
  Result<void> ExecuteProcessOrder(ProcessVerb verb, const PlanStep& step);
  Result<void> ExecuteLifecycleOrder(LifecycleVerb verb, const PlanStep& step);
  Result<void> StartSuspended(const PlanStep& step);

  GcmClient& client_;
  const std::chrono::milliseconds timeout_;
  bool has_lock_ = false;
};

}  // namespace tendon
