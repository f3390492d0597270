#pragma once

#include <tendon/gcm/client.h>
#include <tendon/gcm/system/plan_execution.h>

#include <chrono>
#include <string>

namespace tendon {

/// Carries out steps by asking a GCM for them. Refuses a step of a process that was started anew
/// since it was planned, that of a configuration which was changed since, and the start of a
/// component that lacks a connection which it needs.
class ClientExecutor final : public PlanExecutor {
 public:
  /// The client gives up each request after `timeout` by itself, and outlives the executor. So long
  /// a start waits for the connections that it needs.
  ClientExecutor(GcmClient& client, std::chrono::milliseconds timeout)
      : client_(client), timeout_(timeout) {}

  /// A GCM that knows of no turns denies one, as it does to a viewer: then there is none to wait
  /// for.
  Result<void> Begin() override;
  /// Also refused where the turn was lost with the link to the GCM, and another has it now.
  Result<void> Execute(const PlanStep& step) override;
  void End() override;

 private:
  [[nodiscard]] Result<void> AskForTurn();
  [[nodiscard]] Result<void> KeepTurn();
  [[nodiscard]] Result<void> CheckInstance(const PlanStep& step) const;
  [[nodiscard]] Result<void> AwaitConnections(const PlanStep& step) const;
  Result<void> Connect(const PlanStep& step);
  [[nodiscard]] bool IsMadeByOthers(const message::Wire& wire, ErrorCode refusal) const;
  Result<void> SteerProcess(ProcessVerb verb, const PlanStep& step);
  Result<void> Steer(LifeVerb verb, const PlanStep& step);
  Result<void> StartSuspended(const PlanStep& step);

  GcmClient& client_;
  const std::chrono::milliseconds timeout_;
  bool has_turn_ = false;
};

}  // namespace tendon
