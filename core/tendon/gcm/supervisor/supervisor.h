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

/// Starts processes on the GCM's host, and ends the processes that it has started. Depending on the
/// restart policy, restarts a failed process with its former components and states; the GCM then
/// restores its connections. A process is not restarted if it was ended on request or ended with
/// exit code 0.
///
/// When the GCM ends, the processes continue to run, but the next GCM does not know that a GCM has
/// started them.
///
/// No function blocks. All functions except Stop() must be called while the owner's lock is held.
/// `done` is called once, after the lock is released.
class Supervisor {
 public:
  /// Takes the owner's lock, calls the given function with the Supervisor, releases the lock, and
  /// runs the deferred actions. Does nothing if the owner no longer exists.
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

  /// Executes an order that `who` has requested. The start of a process is recorded in the history.
  void ExecuteOrder(const message::ProcessOrder& order, const std::string& who, Done done);
  /// Checks all started processes; must be called regularly.
  void Tick();
  /// From now on, no more processes are started; running processes continue.
  void Stop() { worker_.Stop(); }

  /// Called when a component of the process may have changed. If the process is restarted later,
  /// its components are created with their data from the catalogue.
  void NoteChange(const std::string& process);

  /// Returns the started processes, except those that were asked to end.
  [[nodiscard]] message::Children children() const;

  /// Checks that this GCM can end the process that a step has started, and that the process has no
  /// components.
  [[nodiscard]] Result<void> CheckUndo(const message::HistoryEntry& step) const;
  /// Undoes a step that started a process: ends the process. The undo is not recorded in the
  /// history.
  void Undo(const message::HistoryEntry& step, std::chrono::nanoseconds timeout, Done done);

 private:
  enum class Phase {
    kStarting,
    kJoining,
    kRunning,
    kEnding,     ///< was asked to end
    kEnded,      ///< ended, but the catalogue still shows it as a member
    kExamining,  ///< its log is being read
    kPausing,    ///< the pause before a restart
  };

  struct Child {
    RestartPolicy restart = RestartPolicy::kNever;
    std::chrono::milliseconds timeout{0};  ///< time limit for joining
    std::string who{};
    Done done{};  ///< called when the process has joined or ended
    Phase phase = Phase::kStarting;
    SteadyTime begin{};  ///< start of the present run
    SteadyTime until{};  ///< end of the phase, if it has a time limit
    std::shared_ptr<StartedProcess> program{};
    ProcessEnd end{};
    bool is_known = false;     ///< the process has joined, in this run or an earlier run
    bool is_unwanted = false;  ///< was asked to end
    bool is_changed = false;   ///< its components may have changed since the last start
    std::string fault{};       ///< why the supervisor had to end it
    RestartSchedule schedule{};
    std::optional<SystemFile> system{};  ///< the components with which it was started
  };

  void Start(const message::ProcessOrder& order, const std::string& who, Done done);
  void Kill(const std::string& process, std::chrono::milliseconds timeout, Done done);
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
  void Reply(Done done, Result<None> result);

  Parts parts_;
  const Locked locked_;
  std::map<std::string, Child> children_;
  SteadyTime next_log_check_{};
  Worker worker_{"gcm-starts"};
};

}  // namespace tendon::server
