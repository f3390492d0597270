#include <tendon/interface/mailbox.h>

#include <tendon/base/clock.h>
#include <tendon/interface/execution/block_when_full.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <thread>

namespace tendon {
namespace {

std::size_t ArgumentOffset(const Mailbox::SlotShape& argument, std::size_t before) {
  return std::max(before, argument.alignment);
}

}  // namespace

void Mailbox::SlotShape::Cover(const SlotShape& other) {
  size = std::max(size, other.size);
  alignment = std::max(alignment, other.alignment);
  reserve += other.reserve;
}

std::size_t Mailbox::SlotBytes(const SlotShape& argument, std::size_t before) {
  return StrideOf(ArgumentOffset(argument, before) + argument.size, argument.alignment);
}

Mailbox::Mailbox(std::size_t capacity, SlotShape argument, CallerThreads callers,
                 const Server& server, ReadyFlag<>& ready, SteadyTime* event_time,
                 std::uint64_t number)
    : capacity_(capacity),
      argument_offset_(
          ArgumentOffset(argument, event_time == nullptr ? kEntryBytes : kTimedEntryBytes)),
      server_(server),
      ready_(ready),
      event_time_(event_time),
      number_(number),
      completions_(std::bit_ceil(std::max<std::size_t>(capacity + argument.reserve, 1))) {
  const std::size_t size = argument_offset_ + argument.size;
  const std::size_t alignment = std::max(alignof(Entry*), argument.alignment);
  if (callers == CallerThreads::kOneThread) {
    one_.emplace(capacity, size, alignment, argument.reserve);
  } else {
    many_.emplace(capacity, size, alignment, argument.reserve);
  }
}

Status Mailbox::refusal() const noexcept {
  if (closed_.Get()) return Status::kNotConnected;
  return accepting() ? Status::kQueueFull : Status::kNotActive;
}

void Mailbox::GiveUp(std::byte* argument) noexcept {
  class SkippedEntry final : public Entry {
    void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {}
  };
  // Never freed, because a task may still use it when the program ends.
  static SkippedEntry& skipped = *new SkippedEntry;
  Publish(argument, skipped);
}

/// Waits until a slot is free and claims it. Returns null at the deadline of BlockWhenFull. Returns
/// null at once in a thread without BlockWhenFull, and in the thread that executes this mailbox.
std::byte* Mailbox::AwaitRoom() noexcept {
  constexpr std::chrono::microseconds kBetweenLooks(200);
  const SteadyTime deadline = BlockWhenFull::deadline();
  if (deadline == SteadyTime::min()) return nullptr;  // the usual case; needs no clock
  std::byte* slot = nullptr;
  while (slot == nullptr && is_open() && !is_executed_here() && SteadyClock().Now() < deadline) {
    std::this_thread::sleep_for(kBetweenLooks);
    slot = TryClaim();
  }
  return slot;
}

bool Mailbox::DropOne() noexcept { return many_ ? DropIn(*many_) : DropIn(*one_); }

template <typename Ring>
bool Mailbox::DropIn(Ring& ring) noexcept {
  std::byte* const slot = ring.Front();
  if (slot == nullptr) return false;
  EntryIn(slot).DropSlot(slot + argument_offset_, ring.IndexOf(slot));
  ring.Release();
  return true;
}

}  // namespace tendon
