#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/gcm_messages.h>
#include <tendon/gcm/members/deferred_actions.h>
#include <tendon/gcm/members/registry.h>
#include <tendon/gcm/step_history.h>
#include <tendon/gcm/supervisor/launcher.h>
#include <tendon/gcm/supervisor/restart_schedule.h>
#include <tendon/middleware/body.h>
#include <tendon/process/worker.h>

#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tendon::server {

/// Starts processes on the GCM's host and ends those that it has started. If requested, restarts a
/// failed process with its former components and states; the GCM restores its connections. A
/// process that was ended by request, or with exit code 0, is not restarted. When the GCM ends, its
/// processes continue, and the next GCM does not know that a GCM has started them.
///
/// No thread waits. All functions except Stop() are called under the owner's lock; `done` is called
/// once, without it.
class Supervisor {
 public:
  /// Calls its argument with the Supervisor, under the owner's lock, and then runs the deferred
  /// actions. Does nothing if the owner is gone.
  using Locked = std::function<void(const std::function<void(Supervisor&)>&)>;
  using Done = std::function<void(Result<None>)>;

  struct Parts {
    Registry& registry;
    StepHistory& history;
    DeferredActions& deferred;
    const Clock& clock;
    std::shared_ptr<Launcher> launcher;
  };
  Supervisor(Parts parts, Locked locked);

  /// Executes an order that `who` has requested. A start is recorded in the history.
  void ExecuteOrder(const message::ProcessOrder& order, const std::string& who, Done done);
  /// Checks all processes; call it often.
  void Tick();
  /// Starts no more processes; running processes continue.
  void Stop() { worker_.Stop(); }

  /// Called when a component of the process may have changed, so that a restart can restore it.
  void NoteChange(const std::string& process);

  /// The started processes, except those that were asked to end.
  [[nodiscard]] message::Children children() const;

  /// Checks that the process started by a step is still controlled by this GCM and has no
  /// components.
  [[nodiscard]] Result<void> CheckUndo(const message::HistoryEntry& step) const;
  /// Undoes a step. Not recorded in the history.
  void Undo(const message::HistoryEntry& step, std::chrono::nanoseconds patience, Done done);

 private:
  enum class Phase {
    kStarting,
    kJoining,
    kRunning,
    kEnding,     ///< was asked to end
    kEnded,      ///< until the catalogue shows its end
    kExamining,  ///< its log is being read
    kPausing,    ///< waits until it is restarted
  };

  struct Child {
    RestartPolicy restart = RestartPolicy::kNever;
    std::chrono::milliseconds patience{0};  ///< time limit for joining
    std::string who{};
    Done done{};  ///< called when it has joined or ended
    Phase phase = Phase::kStarting;
    SteadyTime begin{};  ///< start of its present run
    SteadyTime until{};  ///< end of a phase with a time limit
    std::shared_ptr<StartedProcess> program{};
    ProcessEnd end{};
    bool is_known = false;     ///< has joined, in this run or an earlier one
    bool is_unwanted = false;  ///< was asked to end
    bool is_changed = false;   ///< its components changed since it was started
    std::string fault{};       ///< why it had to be ended
    RestartSchedule schedule{};
    std::optional<SystemFile> system{};  ///< the components with which it was started
  };

  void Start(const message::ProcessOrder& order, const std::string& who, Done done);
  void Kill(const std::string& process, std::chrono::milliseconds patience, Done done);
  [[nodiscard]] Result<void> CheckStart(const std::string& process) const;
  [[nodiscard]] Result<void> CheckKill(const std::string& process) const;
  void Launch(const std::string& process, Child& child);
  void ShortenLogs();
  void Begin(const std::string& process, const Result<std::shared_ptr<StartedProcess>>& program);
  void Check(const std::string& process, Child& child);
  void OnJoined(const std::string& process, Child& child);
  void EndFaulty(Child& child, const std::string& why);
  void Examine(const std::string& process, Child& child);
  void OnExamined(const std::string& process, const ProcessLog& log);
  void ScheduleRestart(const std::string& process, Child& child, const std::string& how);
  void Drop(const std::string& process, const std::string& how);
  void Report(const std::string& process, const std::string& what);
  [[nodiscard]] bool IsMember(const std::string& process, const Child& child) const;
  [[nodiscard]] std::optional<SystemFile> SystemWith(const std::string& process) const;
  void Answer(Done done, Result<None> result);

  Parts parts_;
  const Locked locked_;
  std::map<std::string, Child> children_;
  SteadyTime next_log_check_{};
  Worker worker_{"gcm-starts"};
};

}  // namespace tendon::server
