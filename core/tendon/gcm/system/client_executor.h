#pragma once

#include <tendon/gcm/client.h>
#include <tendon/gcm/system/plan_execution.h>

#include <chrono>
#include <string>

namespace tendon {

/// Executes steps through a GCM. Refuses a step if its process was restarted, or its configuration
/// changed, after the planning; also refuses to start a component without a connection that it
/// needs.
class ClientExecutor final : public PlanExecutor {
 public:
  /// The client must outlive the executor, and ends each request after `timeout`. A start waits
  /// this long for the connections that the component needs.
  ClientExecutor(GcmClient& client, std::chrono::milliseconds timeout)
      : client_(client), timeout_(timeout) {}

  /// Also succeeds if the GCM answers kDenied, because it has no such lock, or because the client
  /// is a viewer: then there is no lock to wait for.
  Result<void> Begin() override;
  /// Also refuses if the lock was lost with the link to the GCM, and another viewer has it now.
  Result<void> Execute(const PlanStep& step) override;
  void End() override;

 private:
  [[nodiscard]] Result<void> TakeLock();
  [[nodiscard]] Result<void> KeepLock();
  [[nodiscard]] Result<void> CheckInstance(const PlanStep& step) const;
  [[nodiscard]] Result<void> AwaitConnections(const PlanStep& step) const;
  Result<void> Connect(const PlanStep& step);
  [[nodiscard]] bool IsMadeByOthers(const message::Wire& wire, ErrorCode refusal) const;
  Result<void> ExecuteProcessOrder(ProcessVerb verb, const PlanStep& step);
  Result<void> ExecuteLifecycleOrder(LifecycleVerb verb, const PlanStep& step);
  Result<void> StartSuspended(const PlanStep& step);

  GcmClient& client_;
  const std::chrono::milliseconds timeout_;
  bool has_lock_ = false;
};

}  // namespace tendon
