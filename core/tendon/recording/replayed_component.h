#pragma once

#include <tendon/base/rate_limited_warning.h>
#include <tendon/interface/event.h>
#include <tendon/manager/component_description.h>
#include <tendon/recording/recording_reader.h>
#include <tendon/state/state_table.h>
#include <tendon/task/component.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace tendon::recording {

/// An event that the replay raises with encoded values, as they are in the recording.
class ReplayedEvent final : public EventBase {
 public:
  /// One thread at a time.
  void Raise(std::span<const std::byte> value);

 private:
  /// Handlers are called with encoded values.
  [[nodiscard]] std::unique_ptr<CommandBase> Adapt(CommandBase& /*handler*/) const override {
    return nullptr;
  }

  std::vector<std::byte> nothing_;
};

/// An event of an interface, as recorded.
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

/// The state tables, events and calls of a recorded component. The replay fills it; a
/// ReplayedComponent offers it, and may end earlier. `source` is the index in
/// RecordingReader::sources().
///
/// Thread safety: after all is added, one thread writes rows and raises events.
class ReplayedMembers {
 public:
  /// `period` is the time between two rows, from which the length of the table follows. Throws
  /// ConfigurationError for names that are not allowed, and for rows that are too large.
  void AddTable(std::size_t source, const RecordedSource& table, std::chrono::nanoseconds period);
  void AddEvents(std::size_t source, const RecordedSource& events);
  void AddCommands(std::size_t source, const RecordedSource& commands);

  /// `time` is that of the row.
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
    std::vector<std::vector<std::byte>> cells;  // the variables of its columns
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

/// Has the interfaces of a recorded component: its state tables, its events, and its commands,
/// which are refused. Observers of its commands see only the recorded calls. A read command works
/// if it returns a structure that exactly one column of the component has as its type, and that
/// column was recorded: it returns the newest value of the column, as such commands usually do.
class ReplayedComponent final : public Component {
 public:
  struct Options {
    /// As recorded; null if the recording has no description of it. Not kept.
    const ComponentDescription* description = nullptr;
    std::string refusal;  ///< the sentence about commands: "this is a replay of run.mcap"
  };

  /// Throws ConfigurationError as ReplayedMembers does.
  ReplayedComponent(std::string name, std::shared_ptr<ReplayedMembers> members,
                    const Options& options);

  [[nodiscard]] std::vector<const StateTable*> tables() const override {
    return members_->tables();
  }
  [[nodiscard]] double period() const override { return period_; }

 private:
  void AddInterface(const ProvidedDescription& provided, const Options& options);
  void AddSilentEvent(const MemberDescription& event, ProvidedInterface& interface);

  const std::shared_ptr<ReplayedMembers> members_;
  double period_ = 0.0;
  std::vector<std::unique_ptr<ReplayedEvent>> silent_events_;  // that are not in the recording
  RateLimitedWarning refused_;
};

}  // namespace tendon::recording
