#pragma once

#include <tendon/lockfree/counter.h>
#include <tendon/lockfree/flag.h>
#include <tendon/lockfree/slot_ring.h>
#include <tendon/lockfree/wakeup.h>

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <new>

namespace tendon {

/// The calls of one connection that wait for the thread of the component called: one ring whose
/// slot holds the command and its argument together, usually in one cache line.
///
/// Thread safety: one thread posts (Claim, Publish), one thread executes (ExecuteOne). Neither ever
/// waits, locks or allocates.
class Mailbox {
 public:
  /// Whoever can execute what a slot holds.
  class Entry {
   public:
    virtual ~Entry() = default;
    /// In the executing thread. May throw what the author's code throws; the slot is freed all the
    /// same.
    virtual void ExecuteSlot(std::byte* argument, std::size_t slot) = 0;
  };

  /// What the arguments of a connection need: the maximum over its commands.
  struct SlotShape {
    std::size_t size = 0;
    std::size_t alignment = 1;

    void Cover(const SlotShape& other);
  };

  /// `accepting` and `wakeup` belong to the inbox; `wakeup` may be null.
  Mailbox(std::size_t capacity, SlotShape argument, const Flag& accepting, Wakeup<>* wakeup);

  /// Room for the next call's argument, or null when the mailbox is full or closed: counted, and
  /// nothing has happened.
  std::byte* Claim() noexcept;
  /// The stable number of the claimed slot, below storage().
  [[nodiscard]] std::size_t claimed_slot() const noexcept { return claimed_; }
  /// Hands the claimed slot over; `entry` will execute it.
  void Publish(Entry& entry) noexcept;

  /// Executes the oldest call; false when there is none.
  bool ExecuteOne();
  /// Frees the oldest call without executing it; false when there is none.
  bool DiscardOne();

  /// From now on Claim() refuses.
  void Close() noexcept { closed_.Set(true); }
  [[nodiscard]] bool closed() const noexcept { return closed_.Get(); }
  /// Whether the component it belongs to executes calls.
  [[nodiscard]] bool accepting() const noexcept { return accepting_.Get(); }

  [[nodiscard]] std::size_t size() const noexcept { return ring_.size(); }
  [[nodiscard]] std::size_t capacity() const noexcept { return ring_.capacity(); }
  /// Slots there are in memory: a pool of this many arguments has one for each.
  [[nodiscard]] std::size_t storage() const noexcept { return ring_.storage(); }
  /// How often Claim() has refused.
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_.value(); }

 private:
  SlotRing<> ring_;
  std::size_t argument_offset_;
  std::byte* slot_ = nullptr;
  std::size_t claimed_ = 0;
  const Flag& accepting_;
  Wakeup<>* wakeup_;
  Counter<> refused_;
  Flag closed_;
};

inline void Mailbox::SlotShape::Cover(const SlotShape& other) {
  size = std::max(size, other.size);
  alignment = std::max(alignment, other.alignment);
}

inline Mailbox::Mailbox(std::size_t capacity, SlotShape argument, const Flag& accepting,
                        Wakeup<>* wakeup)
    : ring_(capacity, std::max(sizeof(Entry*), argument.alignment) + argument.size,
            std::max(alignof(Entry*), argument.alignment)),
      argument_offset_(std::max(sizeof(Entry*), argument.alignment)),
      accepting_(accepting),
      wakeup_(wakeup) {}

inline std::byte* Mailbox::Claim() noexcept {
  slot_ = closed() ? nullptr : ring_.Claim();
  if (slot_ == nullptr) {
    refused_.Add();
    return nullptr;
  }
  claimed_ = ring_.IndexOf(slot_);
  return slot_ + argument_offset_;
}

inline void Mailbox::Publish(Entry& entry) noexcept {
  assert(slot_ != nullptr);
  new (slot_) Entry*(&entry);
  ring_.Publish();
  if (wakeup_ != nullptr) wakeup_->Notify();
}

inline bool Mailbox::DiscardOne() {
  if (ring_.Front() == nullptr) return false;
  ring_.Release();
  return true;
}

inline bool Mailbox::ExecuteOne() {
  std::byte* slot = ring_.Front();
  if (slot == nullptr) return false;
  struct Release {
    SlotRing<>& ring;
    ~Release() { ring.Release(); }
  } const release{ring_};
  Entry* entry = *std::launder(reinterpret_cast<Entry**>(slot));
  entry->ExecuteSlot(slot + argument_offset_, ring_.IndexOf(slot));
  return true;
}

}  // namespace tendon
