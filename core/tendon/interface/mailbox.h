#pragma once

#include <tendon/interface/execution/completion_pool.h>
#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/ready_flag.h>
#include <tendon/lockfree/shared_slot_ring.h>
#include <tendon/lockfree/slot_ring.h>
#include <tendon/lockfree/wakeup.h>

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <thread>

namespace tendon {

/// The threads that call through an interface or raise its events.
enum class CallerThreads {
  kOneThread,    ///< one at a time: the task's own thread
  kManyThreads,  ///< several at once: the component has no thread, or drivers call back
};

/// Holds the calls of one connection until the thread of the called component executes them. It is
/// a ring buffer; a slot holds the command and its argument together, usually in one cache line.
///
/// Thread safety: one thread or many, depending on `callers`, post (Claim, Publish); one thread
/// executes (ExecuteOne). Posting never locks or allocates, and waits only in a thread with
/// BlockWhenFull.
class Mailbox {
 public:
  /// Executes the content of a slot.
  class Entry {
   public:
    virtual ~Entry() = default;
    /// Executes the call in the executing thread. Throws the exceptions of the author's code; the
    /// slot is freed anyway.
    virtual void ExecuteSlot(std::byte* argument, std::size_t slot) = 0;
    /// Called instead of ExecuteSlot() if the call will not be executed.
    virtual void DropSlot(std::byte* /*argument*/, std::size_t /*slot*/) noexcept {}
  };

  /// The memory that the arguments of a connection need in a slot: `size` and `alignment` are the
  /// maximum over all commands. `reserve` is the sum of the slots that the commands reserve.
  struct SlotShape {
    std::size_t size = 0;
    std::size_t alignment = 1;
    std::size_t reserve = 0;

    void Cover(const SlotShape& other);
  };

  /// Number of bytes before the argument of a slot: the pointer to its entry and, if the slots have
  /// times, the time.
  static constexpr std::size_t kEntryBytes = sizeof(Entry*);
  static constexpr std::size_t kTimedEntryBytes = kEntryBytes + sizeof(SteadyTime);
  /// Returns the size of a slot in bytes; `before` is the number of bytes before its argument.
  [[nodiscard]] static std::size_t SlotBytes(const SlotShape& argument, std::size_t before);

  /// Data about the called component, which all its mailboxes share.
  struct Server {
    Flag accepting;  ///< true if the component executes calls
    /// The thread that executes calls; none until a thread is bound.
    Published<std::thread::id> thread;
    Wakeup<>* wakeup = nullptr;  ///< notified when a call is posted
  };

  /// `server` and `ready` must outlive the mailbox. `ready` is raised after a call is posted. If
  /// `event_time` is given, each slot also stores the time at which its call was posted; the
  /// executing thread copies this time to `event_time` before the call.
  Mailbox(std::size_t capacity, SlotShape argument, CallerThreads callers, const Server& server,
          ReadyFlag<>& ready, SteadyTime* event_time = nullptr, std::uint64_t number = 0);

  /// The number of this mailbox, unique among all mailboxes that its inbox has ever had.
  [[nodiscard]] std::uint64_t number() const noexcept { return number_; }

  /// Claims a slot, and returns the memory for the argument of the next call. With many callers,
  /// each claimed slot must be published. Returns null if the mailbox is closed or full; if it is
  /// full, counts the call in refused(). In a thread with BlockWhenFull, waits for room first.
  std::byte* Claim() noexcept;
  /// Like Claim(), but never waits.
  std::byte* ClaimAtOnce() noexcept;
  /// Like Claim(), but claims a reserved slot. Returns null if all reserved slots are in use.
  std::byte* ClaimReserved() noexcept;
  /// The reason why Claim() returned null.
  [[nodiscard]] Status refusal() const noexcept;
  /// Returns the number of the slot that has this argument. The number is below storage() and never
  /// changes.
  [[nodiscard]] std::size_t SlotOf(const std::byte* argument) const noexcept;
  /// Hands the claimed slot to the server, which will execute `entry`.
  void Publish(std::byte* argument, Entry& entry) noexcept;
  /// Called instead of Publish() if the argument could not be created. The server skips the slot.
  void GiveUp(std::byte* argument) noexcept;

  /// Executes the oldest call. Returns false if no call is queued.
  bool ExecuteOne();
  /// Frees the oldest call without executing it. Returns false if no call is queued.
  bool DropOne() noexcept;

  /// From now on, Claim() returns null.
  void Close() noexcept { closed_.Set(true); }
  [[nodiscard]] bool is_open() const noexcept { return !closed_.Get() && accepting(); }
  /// From now on, calls are accepted, but not executed until Release().
  void Hold() noexcept { held_.Set(true); }
  void Release() noexcept { held_.Set(false); }
  [[nodiscard]] bool is_held() const noexcept { return held_.Get(); }
  /// From now on, queued calls are not executed any more.
  void Abandon() noexcept { abandoned_.Set(true); }
  [[nodiscard]] bool is_abandoned() const noexcept { return abandoned_.Get(); }
  /// Set while a command of the called component may have observers.
  void SetObserved(bool is_observed) noexcept { observed_.Set(is_observed); }
  [[nodiscard]] bool is_observed() const noexcept { return observed_.Get(); }
  /// True if the called component executes calls.
  [[nodiscard]] bool accepting() const noexcept { return server_.accepting.Get(); }
  /// True if the calling thread is the one that executes the posted calls.
  [[nodiscard]] bool is_executed_here() const noexcept {
    return server_.thread.Get() == std::this_thread::get_id();
  }

  /// The completion records of calls whose callers wait.
  [[nodiscard]] CompletionPool& completions() noexcept { return completions_; }

  [[nodiscard]] std::size_t size() const noexcept { return many_ ? many_->size() : one_->size(); }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  /// Number of calls that were taken out of the mailbox. Nearly all of them were executed.
  [[nodiscard]] std::uint64_t taken() const noexcept {
    return many_ ? many_->released() : one_->released();
  }
  /// Number of slots in memory. A pool of arguments has one argument for each slot.
  [[nodiscard]] std::size_t storage() const noexcept { return completions_.size(); }
  /// Number of calls that were refused because the mailbox was full.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.value(); }
  void CountRefused() noexcept { refused_.Add(); }
  /// Number of calls that were replaced by newer calls of the same command.
  [[nodiscard]] std::uint64_t replaced() const noexcept { return replaced_.value(); }
  void CountReplaced() noexcept { replaced_.Add(); }

 private:
  [[nodiscard]] std::byte* TryClaim() noexcept { return many_ ? many_->Claim() : one_->Claim(); }
  std::byte* AwaitRoom() noexcept;
  template <typename Ring>
  bool ExecuteIn(Ring& ring);
  template <typename Ring>
  bool DropIn(Ring& ring) noexcept;
  static Entry& EntryIn(std::byte* slot) noexcept {
    return **std::launder(reinterpret_cast<Entry**>(slot));
  }
  static std::byte* TimeIn(std::byte* slot) noexcept {
    return slot + sizeof(Entry*);  // NOLINT(bugprone-sizeof-expression): a slot begins with it
  }

  std::optional<SlotRing<>> one_;  // one of the two members is used
  std::optional<SharedSlotRing<>> many_;
  std::size_t capacity_;
  std::size_t argument_offset_;
  const Server& server_;
  ReadyFlag<>& ready_;
  SteadyTime* event_time_;
  std::uint64_t number_;
  Flag closed_;
  Flag abandoned_;
  Flag held_;
  Flag observed_;  // in the same word as the flags that the executing thread reads before each call
  CompletionPool completions_;
  // These counters are kept apart from data that the server reads, because callers write them and
  // may retry all the time.
  alignas(kSeparation) SharedCounter<> refused_;
  SharedCounter<> replaced_;
};

inline std::byte* Mailbox::Claim() noexcept {
  if (!is_open()) return nullptr;
  std::byte* slot = TryClaim();
  if (slot == nullptr) slot = AwaitRoom();
  if (slot != nullptr) return slot + argument_offset_;
  refused_.Add();
  return nullptr;
}

inline std::byte* Mailbox::ClaimAtOnce() noexcept {
  if (!is_open()) return nullptr;
  std::byte* const slot = TryClaim();
  if (slot != nullptr) return slot + argument_offset_;
  refused_.Add();
  return nullptr;
}

inline std::byte* Mailbox::ClaimReserved() noexcept {
  std::byte* const slot = many_ ? many_->ClaimReserved() : one_->ClaimReserved();
  return slot == nullptr ? nullptr : slot + argument_offset_;
}

inline std::size_t Mailbox::SlotOf(const std::byte* argument) const noexcept {
  const std::byte* const slot = argument - argument_offset_;
  return many_ ? many_->IndexOf(slot) : one_->IndexOf(slot);
}

inline void Mailbox::Publish(std::byte* argument, Entry& entry) noexcept {
  assert(argument != nullptr);
  std::byte* const slot = argument - argument_offset_;
  new (slot) Entry*(&entry);
  if (event_time_ != nullptr) new (TimeIn(slot)) SteadyTime(StdAtomics::Now());
  many_ ? many_->Publish(slot) : one_->Publish();
  ready_.Raise(server_.wakeup);
}

inline bool Mailbox::ExecuteOne() { return many_ ? ExecuteIn(*many_) : ExecuteIn(*one_); }

template <typename Ring>
bool Mailbox::ExecuteIn(Ring& ring) {
  std::byte* const slot = ring.Front();
  if (slot == nullptr) return false;
  struct SlotRelease {
    Ring& ring;
    ~SlotRelease() { ring.Release(); }
  } const release{ring};
  if (event_time_ != nullptr) {
    *event_time_ = *std::launder(reinterpret_cast<SteadyTime*>(TimeIn(slot)));
  }
  EntryIn(slot).ExecuteSlot(slot + argument_offset_, ring.IndexOf(slot));
  return true;
}

}  // namespace tendon
