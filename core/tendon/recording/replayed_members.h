#pragma once

#include <tendon/base/clock.h>
#include <tendon/interface/event_base.h>
#include <tendon/interface/execution/call_observer.h>
#include <tendon/recording/recording_reader.h>
#include <tendon/state/state_table.h>

#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon::recording {

/// An event that the replay raises with the encoded values of the recording.
class ReplayedEvent final : public EventBase {
 public:
  /// May be called by one thread at a time.
  void Raise(std::span<const std::byte> value);

 private:
  /// Handlers are called with encoded values.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }

  std::vector<std::byte> nothing_;
};

/// A recorded event of an interface.
struct NamedReplayedEvent {
  std::string name;
  Schema type;
  std::unique_ptr<ReplayedEvent> event;
};

/// A command of an interface. Observers see its recorded calls.
struct NamedReplayedCommand {
  std::string name;
  Schema type;  ///< of the calls
  std::shared_ptr<CallEvent> calls;
};

/// The state tables, events and calls of a recorded component. The replay writes to this object,
/// and a ReplayedComponent offers it to others. The ReplayedComponent may be destroyed earlier.
/// `source` is the index in RecordingReader::sources().
///
/// Thread safety: one thread writes rows and raises events, after all members were added.
class ReplayedMembers {
 public:
  /// Adds a table. Its length depends on `period`, the time between two rows. Throws
  /// ConfigurationError if a name is not allowed or a row is too large.
  void AddTable(std::size_t source, const RecordedSource& table, std::chrono::nanoseconds period);
  void AddEvents(std::size_t source, const RecordedSource& events);
  void AddCommands(std::size_t source, const RecordedSource& commands);

  /// Writes a row. `time` is the time of the row.
  void Write(std::size_t source, const RecordedRow& row, SteadyTime time);
  /// Raises an event, or shows a call.
  void Raise(std::size_t source, const RecordedEvent& event);

  [[nodiscard]] std::vector<const StateTable*> tables() const;
  /// The names of the interfaces with recorded events or commands.
  [[nodiscard]] std::vector<std::string> interfaces() const;
  /// The recorded events or commands of an interface; empty if there are none.
  [[nodiscard]] std::span<const NamedReplayedEvent> EventsOf(const std::string& interface) const;
  [[nodiscard]] std::span<const NamedReplayedCommand> CommandsOf(
      const std::string& interface) const;

 private:
  struct Table {
    std::unique_ptr<StateTable> table;
    std::vector<std::vector<std::byte>> cells;  // the values of its columns
  };
  template <typename Member>
  struct Members {
    std::string interface;
    std::vector<Member> members;
  };
  template <typename Member>
  using MembersBySource = std::map<std::size_t, Members<Member>>;

  std::map<std::size_t, std::unique_ptr<Table>> tables_;  // by source
  MembersBySource<NamedReplayedEvent> events_;            // likewise
  MembersBySource<NamedReplayedCommand> commands_;        // likewise
};

}  // namespace tendon::recording
