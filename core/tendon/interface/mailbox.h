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

/// Who calls through an interface, or raises its events.
enum class Callers {
  kOneThread,    ///< one at a time: a task's own
  kManyThreads,  ///< at the same time: those of thread-less components, foreign callbacks
};

/// The calls of one connection that wait for the thread of the component called: one ring whose
/// slot holds the command and its argument together, usually in one cache line.
///
/// Thread safety: one thread or many, as it was made for, post (Claim, Publish); one thread
/// executes (ExecuteOne). Posting never locks or allocates, and waits only in a thread
/// with PatientCalls.
class Mailbox {
 public:
  /// Whoever can execute what a slot holds.
  class Entry {
   public:
    virtual ~Entry() = default;
    /// In the executing thread. May throw what the author's code throws; the slot is freed all the
    /// same.
    virtual void ExecuteSlot(std::byte* argument, std::size_t slot) = 0;
    /// Instead of ExecuteSlot(): the call will not be executed.
    virtual void DropSlot(std::size_t /*slot*/) noexcept {}
  };

  /// What the arguments of a connection need: the maximum over its commands; and how many slots
  /// they want reserved, all together.
  struct SlotShape {
    std::size_t size = 0;
    std::size_t alignment = 1;
    std::size_t reserve = 0;

    void Cover(const SlotShape& other);
  };

  /// What stands before the argument of a slot: who executes it, and where slots have one the time.
  static constexpr std::size_t kEntryBytes = sizeof(Entry*);
  static constexpr std::size_t kTimedEntryBytes = kEntryBytes + sizeof(SteadyTime);
  /// What one slot takes, whose argument stands behind so many bytes.
  [[nodiscard]] static std::size_t SlotBytes(const SlotShape& argument, std::size_t before);

  /// The component called, as all its mailboxes see it.
  struct Server {
    Flag accepting;                     ///< whether it executes calls
    Published<std::thread::id> thread;  ///< that executes them; nobody's until one is bound
    Wakeup<>* wakeup = nullptr;         ///< told of every post
  };

  /// `server` and `ready`, which is raised after every post, outlive it. Where there is an
  /// `event_time`, each slot has the time of its post, which stands there when it is executed.
  Mailbox(std::size_t capacity, SlotShape argument, Callers callers, const Server& server,
          ReadyFlag<>& ready, SteadyTime* event_time = nullptr, std::uint64_t number = 0);

  /// Of all mailboxes that its inbox has ever had, no other has it.
  [[nodiscard]] std::uint64_t number() const noexcept { return number_; }

  /// Room for the next call's argument, which must be published if there are many callers. Null
  /// when the mailbox is full, which is counted, or not open; nothing has happened. In a thread
  /// with PatientCalls it is null only once that has waited for room.
  std::byte* Claim() noexcept;
  /// Room in the reserve; null when whoever asked for it takes more than it asked for.
  std::byte* ClaimReserved() noexcept;
  /// Why Claim() has refused.
  [[nodiscard]] Status refusal() const noexcept;
  /// The stable number of the slot of a claimed argument, below storage().
  [[nodiscard]] std::size_t SlotOf(const std::byte* argument) const noexcept;
  /// Hands the claimed slot over; `entry` will execute it.
  void Publish(std::byte* argument, Entry& entry) noexcept;
  /// Instead of Publish(), where no argument has come about: the slot passes by without a call.
  void GiveUp(std::byte* argument) noexcept;

  /// Executes the oldest call; false when there is none.
  bool ExecuteOne();
  /// Frees the oldest call without executing it; false when there is none.
  bool DropOne() noexcept;

  /// From now on Claim() refuses.
  void Close() noexcept { closed_.Set(true); }
  [[nodiscard]] bool is_open() const noexcept { return !closed_.Get() && accepting(); }
  /// While it is held, calls arrive and wait: nothing is executed.
  void Hold() noexcept { held_.Set(true); }
  void Release() noexcept { held_.Set(false); }
  [[nodiscard]] bool is_held() const noexcept { return held_.Get(); }
  /// What waits will not be executed any more.
  void Abandon() noexcept { abandoned_.Set(true); }
  [[nodiscard]] bool is_abandoned() const noexcept { return abandoned_.Get(); }
  /// Whether the component it belongs to executes calls.
  [[nodiscard]] bool accepting() const noexcept { return server_.accepting.Get(); }
  /// Whether this very thread would have to execute what it posts.
  [[nodiscard]] bool is_executed_here() const noexcept {
    return server_.thread.Get() == std::this_thread::get_id();
  }

  /// For calls that are waited for.
  [[nodiscard]] CompletionPool& completions() noexcept { return completions_; }

  [[nodiscard]] std::size_t size() const noexcept { return many_ ? many_->size() : one_->size(); }
  [[nodiscard]] std::size_t capacity() const noexcept { return capacity_; }
  /// How many calls have left it, nearly all because they were executed.
  [[nodiscard]] std::uint64_t taken() const noexcept {
    return many_ ? many_->released() : one_->released();
  }
  /// Slots there are in memory: a pool of this many arguments has one for each.
  [[nodiscard]] std::size_t storage() const noexcept { return completions_.size(); }
  /// How many calls were refused because it was full.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.value(); }
  void CountRefused() noexcept { refused_.Add(); }
  /// How many calls were replaced by newer ones of the same command.
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

  std::optional<SlotRing<>> one_;  // one of the two
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
  CompletionPool completions_;
  // Of callers, some of whom try again and again: apart from what the server reads.
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
  struct Released {
    Ring& ring;
    ~Released() { ring.Release(); }
  } const released{ring};
  if (event_time_ != nullptr) {
    *event_time_ = *std::launder(reinterpret_cast<SteadyTime*>(TimeIn(slot)));
  }
  EntryIn(slot).ExecuteSlot(slot + argument_offset_, ring.IndexOf(slot));
  return true;
}

}  // namespace tendon
