#include <tendon/interface/mailbox.h>

#include <algorithm>
#include <bit>

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

Mailbox::Mailbox(std::size_t capacity, SlotShape argument, Callers callers, const Server& server,
                 ReadyFlag<>& ready, SteadyTime* event_time)
    : capacity_(capacity),
      argument_offset_(
          ArgumentOffset(argument, event_time == nullptr ? kEntryBytes : kTimedEntryBytes)),
      server_(server),
      ready_(ready),
      event_time_(event_time),
      completions_(std::bit_ceil(std::max<std::size_t>(capacity + argument.reserve, 1))) {
  const std::size_t size = argument_offset_ + argument.size;
  const std::size_t alignment = std::max(alignof(Entry*), argument.alignment);
  if (callers == Callers::kOneThread) {
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
  class Nothing final : public Entry {
    void ExecuteSlot(std::byte* /*argument*/, std::size_t /*slot*/) override {}
  };
  static Nothing& nothing = *new Nothing;  // a task may come upon it while the program ends
  Publish(argument, nothing);
}

bool Mailbox::DropOne() noexcept { return many_ ? DropIn(*many_) : DropIn(*one_); }

template <typename Ring>
bool Mailbox::DropIn(Ring& ring) noexcept {
  std::byte* const slot = ring.Front();
  if (slot == nullptr) return false;
  EntryIn(slot).DropSlot(ring.IndexOf(slot));
  ring.Release();
  return true;
}

}  // namespace tendon
