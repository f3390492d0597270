#pragma once

#include <tendon/interface/command.h>
#include <tendon/interface/mailbox.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/ready_flag.h>

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace tendon {

/// Holds all mailboxes of one component, for commands and for events. Also stores which thread
/// empties them.
///
/// Thread safety: the component's thread calls ExecuteQueued(). Managers call Open() and Remove()
/// at any time.
class Inbox {
 public:
  /// `wakeup`, if given, is notified when a call is posted. It is for a thread that sleeps until a
  /// call arrives.
  explicit Inbox(Wakeup<>* wakeup = nullptr);
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;
  ~Inbox();

  /// Adds a mailbox, which the inbox owns until Remove(). While a call is executed, `event_time`,
  /// if given, holds the time at which the call was posted. Locks and allocates.
  Mailbox& Open(std::size_t capacity, Mailbox::SlotShape argument,
                CallerThreads callers = CallerThreads::kOneThread,
                SteadyTime* event_time = nullptr);

  /// Closes and removes `mailbox`. Waits until no thread executes its calls. Then frees the mailbox
  /// and `commands`, to which its slots refer. If a handler has not returned by `deadline`, frees
  /// the mailbox and the commands later. Returns the number of calls that were never executed.
  std::size_t Remove(Mailbox& mailbox, std::vector<std::unique_ptr<CommandBase>> commands = {},
                     SteadyTime deadline = SteadyTime::max());

  /// Executes the calls that are queued now, at most `limit`, and returns their number. Serves the
  /// mailboxes in turn, so that a fast client cannot starve the others. A nested call does nothing.
  /// Takes no lock and allocates nothing itself. An empty mailbox costs one load of a byte; the
  /// bytes of all mailboxes are adjacent.
  std::size_t ExecuteQueued(std::size_t limit = std::numeric_limits<std::size_t>::max());

  /// True if a call is queued. Called in the executing thread; takes no lock.
  [[nodiscard]] bool has_queued() noexcept;

  /// Frees all queued calls without executing them, and returns their number. Call it only while no
  /// thread executes calls.
  std::size_t DiscardQueued();

  /// While there are observers of commands, all mailboxes are marked; see Mailbox::is_observed().
  void AddObserver();
  void RemoveObserver();

  /// Sets whether calls are accepted. If not, new calls are refused with kNotActive, and callers
  /// that already wait get kNotActive as well.
  void SetAccepting(bool accepting);
  [[nodiscard]] bool accepting() const noexcept { return server_.accepting.Get(); }

  /// Binds the calling thread until Unbind(). A bound thread executes all calls, and only this
  /// thread calls the functions and raises the events of the component. For tasks.
  void BindToThisThread() noexcept {
    const std::thread::id here = std::this_thread::get_id();
    if (server_.thread.Get() != here) server_.thread.Set(here);
  }
  void Unbind() noexcept { server_.thread.Set({}); }
  /// True if a thread other than the calling one is bound.
  [[nodiscard]] bool IsForeignThread() const noexcept {
    const std::thread::id bound = server_.thread.Get();
    return bound != std::thread::id() && bound != std::this_thread::get_id();
  }

  /// Number of queued calls in all mailboxes.
  [[nodiscard]] std::size_t size() const;

  /// The fill level of a mailbox. fill() locks, and returns the level of the mailbox that is
  /// fullest relative to its capacity; zeros if there is no mailbox.
  struct Fill {
    std::size_t waiting = 0;
    std::size_t capacity = 0;
  };
  [[nodiscard]] Fill fill() const;

 private:
  static constexpr std::size_t kRow = 64;
  struct alignas(kCacheLine) FlagRow {
    std::array<ReadyFlag<>, kRow> flags;
  };
  /// An element is null if its place is free.
  using Mailboxes = std::vector<Mailbox*>;
  struct List {
    std::vector<FlagRow*> rows;
    Mailboxes mailboxes;

    [[nodiscard]] ReadyFlag<>& FlagOf(std::size_t place) const {
      return rows[place / kRow]->flags[place % kRow];
    }
    /// Runs `action(Mailbox&, waiting) -> bool` for each non-empty mailbox until it returns false.
    template <typename Action>
    void ForEachReady(ReadyFlag<>::IfEmpty if_empty, Action action) const;
  };
  /// Data that a handler may still use because it has not returned.
  struct RetiredMailbox {
    std::unique_ptr<List> list;
    std::unique_ptr<Mailbox> mailbox;
    std::vector<std::unique_ptr<CommandBase>> commands;
  };

  void CountObservers(std::size_t observers);
  std::unique_ptr<List> Copy() const;
  std::size_t FreePlace(List& list);

  Mailbox::Server server_;    // read by callers
  mutable std::mutex mutex_;  // locked by managers, never by ExecuteQueued()
  std::vector<std::unique_ptr<FlagRow>> rows_;
  std::vector<std::unique_ptr<Mailbox>> mailboxes_;
  std::unique_ptr<List> list_;
  std::vector<RetiredMailbox> retired_;
  std::uint64_t opened_ = 0;  // number of mailboxes opened so far
  std::size_t observers_ = 0;
  alignas(kSeparation) bool executing_ = false;  // used by the executing thread, like the next two
  unsigned passes_ = 0;
  GuardedPointer<List> current_;
};

}  // namespace tendon
