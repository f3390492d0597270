#include <tendon/process/history/event_history.h>

#include <tendon/base/os/process.h>
#include <tendon/lockfree/completion.h>
#include <tendon/payload/fingerprint.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

namespace tendon {
namespace {

constexpr std::size_t kSizeBytes = 8;  // in a slot, before the value
constexpr std::size_t kQueueBytes = std::size_t{40} << 10U;
constexpr std::size_t kFewestSlots = 8;
constexpr std::size_t kMaxSlots = 128;

std::size_t CapacityFor(std::size_t slot) {
  return std::clamp(std::bit_floor(kQueueBytes / slot), kFewestSlots, kMaxSlots);
}

bool HasFixedSize(const Schema& schema) {
  switch (schema.kind()) {
    case Schema::Kind::kString:
    case Schema::Kind::kSequence:
      return false;
    case Schema::Kind::kArray:
      return HasFixedSize(schema.element());
    default:
      return std::ranges::all_of(schema.fields(),
                                 [](const auto& field) { return HasFixedSize(field.schema); });
  }
}

/// The room for a value: the largest size of its type, if this is known and not too large.
std::size_t RoomFor(const MemberDescription& event) {
  constexpr std::size_t kUsual = 248;
  const auto schema = FindSchema(event.signature.in);
  if (!schema || !HasFixedSize(*schema)) return EventHistory::kLargestDynamicValue;
  // Padding at most doubles the size.
  return std::clamp(2 * schema->minimum_size(), kUsual, EventHistory::kLargestValue);
}

}  // namespace

/// Handles one event. It never refuses an event, because the component would count it as lost.
class EventHistory::Handler final : public CommandBase, private Mailbox::Entry {
 public:
  Handler(EventHistory& history, std::uint32_t event, EventBase& source, Mailbox& mailbox,
          std::size_t room, const std::function<void()>& on_filling)
      : CommandBase(layout::kNone, layout::kNone),
        history_(history),
        event_(event),
        source_(source),
        mailbox_(mailbox),
        room_(room),
        on_filling_(on_filling) {
    source_.Subscribe(*this);
  }
  void Unsubscribe() { source_.Unsubscribe(*this); }

  [[nodiscard]] std::uint64_t missed() const { return missed_.value(); }

  Status ExecuteEncoded(std::span<const std::byte> in, ReplySink& /*out*/) override {
    return Post(in.size(), [&](std::span<std::byte> place) {
      std::ranges::copy(in, place.begin());
      return true;
    });
  }
  Status ExecuteFrom(const ArgumentWriter& in, ReplySink& /*out*/) override {
    return Post(in.size(), [&](std::span<std::byte> place) { return in.WriteTo(place); });
  }

 private:
  template <typename Write>
  Status Post(std::size_t size, Write write) {
    // A component never waits for its history.
    std::byte* const slot = size <= room_ ? mailbox_.ClaimAtOnce() : nullptr;
    if (slot == nullptr) {
      missed_.Add();
      return Status::kQueued;
    }
    const std::uint64_t bytes = size;
    std::memcpy(slot, &bytes, sizeof bytes);
    const Status written = ComponentAccess::CatchExceptions(nullptr, [&]() -> Status {
      return write(std::span(slot + kSizeBytes, size)) ? Status::kQueued : Status::kFailed;
    });
    if (written) {
      mailbox_.Publish(slot, *this);
    } else {
      missed_.Add();
      mailbox_.GiveUp(slot);
    }
    if (2 * mailbox_.size() >= mailbox_.capacity()) on_filling_();
    return Status::kQueued;
  }

  void ExecuteSlot(std::byte* argument, std::size_t /*slot*/) override {
    std::uint64_t size = 0;
    std::memcpy(&size, argument, sizeof size);
    history_.Keep(event_, std::span(argument + kSizeBytes, size));
  }

  EventHistory& history_;
  const std::uint32_t event_;
  EventBase& source_;
  Mailbox& mailbox_;
  const std::size_t room_;
  const std::function<void()> on_filling_;
  SharedCounter<> missed_;
};

EventHistory::EventHistory(std::string component, ProvidedInterface& provided,
                           HistoryMemory& memory, std::chrono::nanoseconds span)
    : component_(std::move(component)),
      interface_(provided.name()),
      provided_(provided),
      memory_(memory),
      epoch_(os::RandomNumber()),
      ring_(memory, span) {}

/// If there is no memory for a later step, the destructor undoes the earlier steps. It runs because
/// this constructor has first called another constructor, which has succeeded.
EventHistory::EventHistory(std::string component, ProvidedInterface& provided,
                           HistoryMemory& memory, std::chrono::nanoseconds span,
                           const std::function<void()>& on_filling)
    : EventHistory(std::move(component), provided, memory, span) {
  const ProvidedDescription description = provided_.description();
  std::size_t room = 0;
  for (const MemberDescription& event : description.events) {
    events_.push_back(event.name);
    room = std::max(room, RoomFor(event));
  }
  const Mailbox::SlotShape shape{.size = kSizeBytes + room, .alignment = kSizeBytes};
  const std::size_t slot =
      Mailbox::SlotBytes(shape, Mailbox::kTimedEntryBytes) + sizeof(Completion<>);
  const std::size_t capacity = CapacityFor(slot);
  if (events_.empty() || !memory_.Reserve(capacity * slot)) return;
  reserved_ = capacity * slot;
  inbox_.SetAccepting(true);
  Mailbox& mailbox = inbox_.Open(capacity, shape, provided_.raisers(), &event_time_);
  handlers_.reserve(events_.size());  // a subscribed handler must not be freed
  for (std::uint32_t i = 0; i < events_.size(); ++i) {
    handlers_.push_back(std::make_unique<Handler>(*this, i, *provided_.FindEvent(events_[i]),
                                                  mailbox, room, on_filling));
  }
}

EventHistory::~EventHistory() {
  for (const auto& handler : handlers_) handler->Unsubscribe();
  inbox_.DiscardQueued();
  memory_.Release(reserved_);
}

std::uint64_t EventHistory::missed() const {
  std::uint64_t missed = 0;
  for (const auto& handler : handlers_) missed += handler->missed();
  return missed;
}

void EventHistory::Gather() {
  inbox_.ExecuteQueued();
  const std::uint64_t missed = this->missed();
  next_number_ += missed - std::exchange(counted_, missed);
}

void EventHistory::Keep(std::uint32_t event, std::span<const std::byte> value) {
  ring_.Append({.number = next_number_++,
                .time = event_time_.time_since_epoch().count(),
                .tag = event,
                .body = value});
}

}  // namespace tendon
