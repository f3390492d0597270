#include <tendon/recording/replayed_members.h>

#include <algorithm>
#include <utility>

namespace tendon::recording {
namespace {

template <typename Map>
auto MembersOf(const Map& by_source, const std::string& interface) {
  const auto found = std::ranges::find_if(
      by_source, [&](const auto& one) { return one.second.interface == interface; });
  return found == by_source.end() ? decltype(std::span(found->second.members))()
                                  : std::span(found->second.members);
}

}  // namespace

void ReplayedEvent::Raise(std::span<const std::byte> value) {
  CallHandlers([&](CommandBase& handler) {
    BytesSink nothing(nothing_);
    return handler.ExecuteEncoded(value, nothing);
  });
}

void ReplayedMembers::AddTable(std::size_t source, const RecordedSource& table,
                               std::chrono::nanoseconds period) {
  auto made = std::make_unique<Table>();
  made->table = std::make_unique<StateTable>(table.name.interface);
  made->cells.resize(table.members.size());
  for (std::size_t i = 0; i < table.members.size(); ++i) {
    const RecordedMember& column = table.members[i];
    made->table->AddEncoded(made->cells[i], column.schema, column.name, column.largest);
  }
  made->table->SetLength(made->table->LengthFor(period));
  made->table->SetFirstTick(table.first_tick);
  made->table->AdvanceOnlyByHand();
  made->table->Prepare();
  tables_[source] = std::move(made);
}

void ReplayedMembers::AddEvents(std::size_t source, const RecordedSource& events) {
  auto& added = events_[source];
  added.interface = events.name.interface;
  for (const RecordedMember& event : events.members) {
    added.members.push_back({event.name, event.schema, std::make_unique<ReplayedEvent>()});
  }
}

void ReplayedMembers::AddCommands(std::size_t source, const RecordedSource& commands) {
  auto& added = commands_[source];
  added.interface = commands.name.interface;
  for (const RecordedMember& command : commands.members) {
    added.members.push_back({command.name, command.schema, std::make_shared<CallEvent>()});
  }
}

void ReplayedMembers::Write(std::size_t source, const RecordedRow& row, SteadyTime time) {
  Table& table = *tables_.at(source);
  for (std::size_t i = 0; i < table.cells.size(); ++i) {
    table.cells[i].assign(row.cells[i].begin(), row.cells[i].end());
  }
  table.table->AdvanceTo(row.tick, time);
}

void ReplayedMembers::Raise(std::size_t source, const RecordedEvent& event) {
  if (const auto commands = commands_.find(source); commands != commands_.end()) {
    commands->second.members.at(event.event).calls->Raise(EncodedArgument(event.value));
  } else {
    events_.at(source).members.at(event.event).event->Raise(event.value);
  }
}

std::vector<const StateTable*> ReplayedMembers::tables() const {
  std::vector<const StateTable*> all;
  for (const auto& [source, table] : tables_) all.push_back(table->table.get());
  return all;
}

std::vector<std::string> ReplayedMembers::interfaces() const {
  std::vector<std::string> all;
  for (const auto& [source, events] : events_) all.push_back(events.interface);
  for (const auto& [source, commands] : commands_) all.push_back(commands.interface);
  return all;
}

std::span<const NamedReplayedEvent> ReplayedMembers::EventsOf(const std::string& interface) const {
  return MembersOf(events_, interface);
}

std::span<const NamedReplayedCommand> ReplayedMembers::CommandsOf(
    const std::string& interface) const {
  return MembersOf(commands_, interface);
}

}  // namespace tendon::recording
