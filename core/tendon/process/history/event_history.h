#pragma once

#include <tendon/interface/provided_interface.h>
#include <tendon/process/history/history_ring.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// Keeps the latest events of one provided interface. The thread that raises an event only copies
/// the encoded value into a small queue, as for any listener. It allocates nothing, never waits,
/// and makes a system call only if the queue is half full. The tag of a record is the index of its
/// event.
///
/// Thread safety: one thread at a time, apart from the threads that raise events. The interface
/// must outlive the history.
class EventHistory {
 public:
  /// The size in bytes of the largest values that are kept: for types of fixed size, and for other
  /// types.
  static constexpr std::size_t kLargestValue = std::size_t{4} << 10U;
  static constexpr std::size_t kLargestDynamicValue = 1000;

  /// A thread that raises an event calls `on_filling` if Gather() should be called soon.
  EventHistory(std::string component, ProvidedInterface& provided, HistoryMemory& memory,
               std::chrono::nanoseconds span, const std::function<void()>& on_filling);
  EventHistory(const EventHistory&) = delete;
  EventHistory& operator=(const EventHistory&) = delete;
  ~EventHistory();

  [[nodiscard]] const std::string& component() const { return component_; }
  [[nodiscard]] const std::string& interface() const { return interface_; }
  /// False if there is no memory for the queue. Then nothing is kept.
  [[nodiscard]] bool has_memory() const { return reserved_ > 0; }
  /// The names of the events, by tag.
  [[nodiscard]] const std::vector<std::string>& events() const { return events_; }
  /// Distinguishes the numbers of these records from the numbers of an earlier interface with the
  /// same name.
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
  [[nodiscard]] const HistoryRing& ring() const { return ring_; }
  [[nodiscard]] HistoryRing& ring() { return ring_; }
  /// The number of the next event.
  [[nodiscard]] std::uint64_t next_number() const { return next_number_; }
  /// Returns the number of events that are not kept because they came too fast or were too large.
  [[nodiscard]] std::uint64_t missed() const;

  /// Moves the events from the queue to the ring.
  void Gather();

 private:
  class Handler;

  /// Keeps nothing yet.
  EventHistory(std::string component, ProvidedInterface& provided, HistoryMemory& memory,
               std::chrono::nanoseconds span);
  void Keep(std::uint32_t event, std::span<const std::byte> value);

  const std::string component_;
  const std::string interface_;
  ProvidedInterface& provided_;
  HistoryMemory& memory_;
  const std::uint64_t epoch_;
  HistoryRing ring_;
  std::size_t reserved_ = 0;  // bytes of the queue
  std::vector<std::string> events_;
  Inbox inbox_;
  SteadyTime event_time_;
  std::uint64_t next_number_ = 0;
  std::uint64_t counted_ = 0;  // missed events that already have numbers
  std::vector<std::unique_ptr<Handler>> handlers_;
};

}  // namespace tendon
