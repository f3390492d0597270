#pragma once

#include <tendon/base/clock.h>
#include <tendon/gcm/history.h>
#include <tendon/gcm/server/outbox.h>
#include <tendon/gcm/server/registry.h>
#include <tendon/gcm/supervisor/children_messages.h>
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

/// Starts processes on the GCM's own host, ends those that it has started, and starts one that has
/// failed again where that is wanted: with the components that it had, in their states; its
/// connections the GCM hands back. One that was told to end, or ended by itself with exit code 0,
/// stays ended. When the GCM ends, they run on, and the next one does not know that they are of a
/// GCM.
///
/// Nobody waits in a thread. All functions but Stop() are called under the lock of the owner;
/// `done` is called once, without.
class Supervisor {
 public:
  /// Calls its argument under the owner's lock, with the Supervisor; not at all once the owner is
  /// gone. What the argument adds to the outbox is sent afterwards.
  using Locked = std::function<void(const std::function<void(Supervisor&)>&)>;
  using Done = std::function<void(Result<None>)>;

  struct Parts {
    Registry& registry;
    History& history;
    Outbox& outbox;
    const Clock& clock;
    std::shared_ptr<Launcher> launcher;
  };
  Supervisor(Parts parts, Locked locked);

  /// `who` asked for it. A start is a step in the history.
  void Obey(const message::ProcessOrder& order, const std::string& who, Done done);
  /// Looks after the processes; to be called often.
  void Tick();
  /// Nothing is started any more; what runs is left alone.
  void Stop() { worker_.Stop(); }

  /// A component of the process is perhaps changed: started again, it is to have what it had.
  void NoteChange(const std::string& process);

  /// Those that are not told to end.
  [[nodiscard]] message::Children children() const;

  /// Whether the process that a step has started is still ours, and has nothing in it.
  [[nodiscard]] Result<void> CheckUndo(const message::HistoryEntry& step) const;
  /// Unmakes a step. Not a step in the history.
  void Undo(const message::HistoryEntry& step, std::chrono::nanoseconds patience, Done done);

 private:
  enum class Phase {
    kStarting,
    kJoining,
    kRunning,
    kEnding,     ///< it was asked to
    kEnded,      ///< until the catalogue knows it
    kExamining,  ///< its log
    kPausing,    ///< until it is started again
  };

  struct Child {
    RestartPolicy restart = RestartPolicy::kNever;
    std::chrono::milliseconds patience{0};  ///< until it has joined
    std::string who{};
    Done done{};  ///< who waits for it to join, or to end
    Phase phase = Phase::kStarting;
    SteadyTime begin{};  ///< of its present life
    SteadyTime until{};  ///< of a phase that does not end by itself
    std::shared_ptr<StartedProcess> program{};
    ProcessEnd end{};
    bool is_known = false;     ///< it has joined, in this life or a former one
    bool is_unwanted = false;  ///< it was told to end
    bool is_changed = false;   ///< since it was started
    std::string reproach{};    ///< why it had to be ended
    RestartSchedule schedule{};
    std::optional<SystemFile> system{};  ///< with what it was started
  };

  void Start(const message::ProcessOrder& order, const std::string& who, Done done);
  void Kill(const std::string& process, std::chrono::milliseconds patience, Done done);
  [[nodiscard]] Result<void> CheckStart(const std::string& process) const;
  [[nodiscard]] Result<void> CheckKill(const std::string& process) const;
  void Launch(const std::string& process, Child& child);
  void ShortenLogs();
  void Begin(const std::string& process, const Result<std::shared_ptr<StartedProcess>>& program);
  void LookAfter(const std::string& process, Child& child);
  void Joined(const std::string& process, Child& child);
  void Reproach(Child& child, const std::string& why);
  void Examine(const std::string& process, Child& child);
  void Judge(const std::string& process, const Traces& traces);
  void StartAgain(const std::string& process, Child& child, const std::string& how);
  void Drop(const std::string& process, const std::string& how);
  void Tell(const std::string& process, const std::string& what);
  [[nodiscard]] bool IsMember(const std::string& process, const Child& child) const;
  [[nodiscard]] std::optional<SystemFile> SystemWith(const std::string& process) const;
  void Answer(Done done, Result<None> result);

  Parts parts_;
  const Locked locked_;
  std::map<std::string, Child> children_;
  SteadyTime next_look_at_logs_{};
  Worker worker_{"gcm-starts"};
};

}  // namespace tendon::server
