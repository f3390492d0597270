#pragma once

#include <tendon/lockfree/completion.h>
#include <tendon/lockfree/flag.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

namespace tendon {

/// The completion records of one mailbox, one per slot. A call whose caller waits takes a record
/// and keeps it until the caller has read the reply. At that time, another call may already use the
/// slot, so the record is not a part of the slot.
class CompletionPool {
 public:
  explicit CompletionPool(std::size_t slots)
      : size_(slots),
        records_(std::make_unique<Completion<>[]>(slots)),
        of_slot_(std::make_unique<std::uint32_t[]>(slots)) {}

  /// Returns the number of a free record for the caller; empty if all are in use. Lock-free.
  [[nodiscard]] std::optional<std::size_t> Take() noexcept {
    for (std::size_t record = 0; record < size_; ++record) {
      if (records_[record].TryTake()) return record;
    }
    return std::nullopt;
  }
  [[nodiscard]] Completion<>& operator[](std::size_t record) noexcept { return records_[record]; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// Producer: assigns the record to the call in a claimed slot.
  void Assign(std::size_t slot, std::size_t record) noexcept {
    of_slot_[slot] = static_cast<std::uint32_t>(record);
  }
  /// Consumer: returns the record of a published slot.
  [[nodiscard]] std::size_t RecordOf(std::size_t slot) const noexcept { return of_slot_[slot]; }

  /// Any thread: ends all waits, present and future.
  void Cancel() noexcept {
    cancelled_.Set(true);
    Interrupt();
  }
  /// Any thread: makes all waiting callers check whether their wait is over.
  void Interrupt() noexcept {
    for (std::size_t record = 0; record < size_; ++record) records_[record].Interrupt();
  }
  [[nodiscard]] bool cancelled() const noexcept { return cancelled_.Get(); }

 private:
  std::size_t size_;
  std::unique_ptr<Completion<>[]> records_;
  std::unique_ptr<std::uint32_t[]> of_slot_;
  Flag cancelled_;
};

}  // namespace tendon
