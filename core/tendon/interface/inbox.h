#pragma once

#include <tendon/interface/mailbox.h>
#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/ready_flag.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace tendon {

class CommandBase;

/// All mailboxes of one component, of commands and of events, and the thread that empties them.
///
/// Thread safety: ExecuteQueued() belongs to the component's thread; Open() and Remove() to
/// managers, at any time.
class Inbox {
 public:
  /// `wakeup`, if any, is told of every post: for a thread that sleeps until something arrives.
  explicit Inbox(Wakeup<>* wakeup = nullptr);
  Inbox(const Inbox&) = delete;
  Inbox& operator=(const Inbox&) = delete;
  ~Inbox();

  /// Adds a mailbox; the inbox owns it until it is removed. Where `event_time` is given it holds,
  /// while a call is executed, the time at which that was posted. Locks and allocates.
  Mailbox& Open(std::size_t capacity, Mailbox::SlotShape argument,
                Callers callers = Callers::kOneThread, SteadyTime* event_time = nullptr);

  /// Closes `mailbox`, takes it out and frees it, and the commands to which its slots refer, once
  /// nobody executes from it. A handler that does not return by `deadline` is left alone with them:
  /// they are freed later. Returns how many calls were never executed.
  std::size_t Remove(Mailbox& mailbox, std::vector<std::unique_ptr<CommandBase>> commands = {},
                     SteadyTime deadline = SteadyTime::max());

  /// Executes what waited at the time of the call, mailbox by mailbox, so that a fast client cannot
  /// starve the others; at most `limit` calls. A nested call does nothing. Returns how many calls
  /// were executed. No lock, no allocation of its own; a mailbox in which nothing waits costs one
  /// look at a byte that lies beside those of the others.
  std::size_t ExecuteQueued(std::size_t limit = std::numeric_limits<std::size_t>::max());

  /// Whether a call waits. In the executing thread; no lock.
  [[nodiscard]] bool has_queued() noexcept;

  /// Frees all that waits without executing it, and returns how much it was. Only while nobody
  /// executes.
  std::size_t DiscardQueued();

  /// While false, posts are refused with kNotActive; who waits for a call is told the same.
  void SetAccepting(bool accepting);
  [[nodiscard]] bool accepting() const noexcept { return server_.accepting.Get(); }

  /// The thread that executes what arrives here, and alone calls the functions and raises the
  /// events of the component, is this one; or it has ended. For tasks.
  void BindToThisThread() noexcept {
    const std::thread::id here = std::this_thread::get_id();
    if (server_.thread.Get() != here) server_.thread.Set(here);
  }
  void Unbind() noexcept { server_.thread.Set({}); }
  /// Whether a thread is bound, and is not this one.
  [[nodiscard]] bool IsForeignThread() const noexcept {
    const std::thread::id bound = server_.thread.Get();
    return bound != std::thread::id() && bound != std::this_thread::get_id();
  }

  /// Calls waiting now, over all mailboxes.
  [[nodiscard]] std::size_t size() const;

  /// Of the mailbox that is fullest, by its capacity; 0 of 0 where there is none. Locks.
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
  /// By place; null where there is none.
  using Mailboxes = std::vector<Mailbox*>;
  struct List {
    std::vector<FlagRow*> rows;
    Mailboxes mailboxes;

    [[nodiscard]] ReadyFlag<>& FlagOf(std::size_t place) const {
      return rows[place / kRow]->flags[place % kRow];
    }
    /// `action(Mailbox&, waiting) -> bool` for each in which calls wait, until one returns false.
    template <typename Action>
    void ForEachReady(ReadyFlag<>::IfEmpty if_empty, Action action) const;
  };
  /// What a handler that has not returned may still use.
  struct Retired {
    std::unique_ptr<List> list;
    std::unique_ptr<Mailbox> mailbox;
    std::vector<std::unique_ptr<CommandBase>> commands;
  };

  std::unique_ptr<List> Copy() const;
  std::size_t FreePlace(List& list);

  Mailbox::Server server_;    // looked at by callers
  mutable std::mutex mutex_;  // of managers; never taken while calls are executed
  std::vector<std::unique_ptr<FlagRow>> rows_;
  std::vector<std::unique_ptr<Mailbox>> mailboxes_;
  std::unique_ptr<List> list_;
  std::vector<Retired> retired_;
  std::uint64_t opened_ = 0;                     // mailboxes
  alignas(kSeparation) bool executing_ = false;  // of the executing thread, as the next two
  unsigned passes_ = 0;
  GuardedPointer<List> current_;
};

}  // namespace tendon
