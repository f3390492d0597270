#include <tendon/interface/column_offer.h>
#include <tendon/recording/replayed_component.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace tendon::recording {
namespace {

/// Refuses each call.
class RefusedCommand final : public CommandBase {
 public:
  RefusedCommand(std::string sentence, RateLimitedWarning& warning)
      : CommandBase(layout::kNone, layout::kNone),
        sentence_(std::move(sentence)),
        warning_(warning) {}

  Status ExecuteEncoded(std::span<const std::byte> /*in*/, AnswerSink& /*out*/) override {
    return Refuse();
  }
  Status WaitEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                     std::chrono::nanoseconds /*timeout*/) override {
    return Refuse();
  }
  Status BeginEncoded(std::span<const std::byte> /*in*/, std::vector<std::byte>& /*out*/,
                      Wakeup<>& /*ended*/, std::size_t& /*call*/) override {
    return Refuse();
  }

 private:
  Status Refuse() {
    warning_.Add(sentence_);
    return Status::kDisabled;
  }

  const std::string sentence_;
  RateLimitedWarning& warning_;
};

class RefusedOffer final : public Offer {
 public:
  RefusedOffer(MemberDescription description, const std::string& refusal,
               RateLimitedWarning& warning)
      : Offer(std::move(description)), warning_(warning) {
    SetRefusal(refusal);
    SetReadsTableOnly();  // a call takes no time
  }

  [[nodiscard]] bool uses_mailbox() const override { return false; }
  [[nodiscard]] std::unique_ptr<CommandBase> Bind(Mailbox* /*mailbox*/) const override {
    return std::make_unique<RefusedCommand>(
        "a call of '" + description().name + "' was refused: " + refusal(), warning_);
  }

 private:
  RateLimitedWarning& warning_;
};

bool IsStateTable(const std::string& interface) {
  return interface == "state" || interface.starts_with("state-");
}

/// The only column of this type in a component, as described: the names of the table and the
/// column. Empty if there is none, or several, of which one may not have been recorded.
std::optional<std::pair<std::string, std::string>> OnlyColumnOf(
    const ComponentDescription& component, const Fingerprint& type) {
  std::optional<std::pair<std::string, std::string>> only;
  for (const TableDescription& table : component.tables) {
    for (const ColumnDescription& column : table.columns) {
      if (column.fingerprint != type) continue;
      if (only) return std::nullopt;
      only.emplace(table.name, column.name);
    }
  }
  return only;
}

/// A read of the column that a read command probably returns; null if there is none.
std::unique_ptr<Offer> ReadOf(const MemberDescription& command,
                              const ComponentDescription& component,
                              const std::vector<const StateTable*>& tables) {
  if (command.signature.kind != CommandKind::kRead) return nullptr;
  const auto place = OnlyColumnOf(component, command.signature.out);
  if (!place) return nullptr;
  for (const StateTable* table : tables) {
    if (table->name() != place->first) continue;
    for (std::size_t i = 0; i < table->columns().size(); ++i) {
      const ColumnBase& column = *table->columns()[i];
      const bool is_structure =
          column.schema().kind() == Schema::Kind::kStructure && !column.schema().is_none();
      const bool is_it = column.name() == place->second && is_structure &&
                         column.fingerprint() == command.signature.out;
      if (is_it) return std::make_unique<ColumnOffer>(command, *table, i);
    }
  }
  return nullptr;
}

MemberDescription DescribeEvent(const std::string& name, const Schema& type) {
  const CommandKind kind = type.is_none() ? CommandKind::kVoid : CommandKind::kWrite;
  MemberDescription description = DescribeMember<None, None>(name, kind);
  if (type.is_none()) return description;
  description.signature.in = payload::Remember(type);
  description.in_type = type.TypeName();
  return description;
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
  Events& added = events_[source];
  added.interface = events.name.interface;
  for (const RecordedMember& event : events.members) {
    added.events.push_back({event.name, event.schema, std::make_unique<ReplayedEvent>()});
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
  events_.at(source).events.at(event.event).event->Raise(event.value);
}

std::vector<const StateTable*> ReplayedMembers::tables() const {
  std::vector<const StateTable*> all;
  for (const auto& [source, table] : tables_) all.push_back(table->table.get());
  return all;
}

std::vector<std::string> ReplayedMembers::interfaces() const {
  std::vector<std::string> all;
  for (const auto& [source, events] : events_) all.push_back(events.interface);
  return all;
}

std::span<const NamedReplayedEvent> ReplayedMembers::EventsOf(const std::string& interface) const {
  const auto found = std::ranges::find_if(
      events_, [&](const auto& one) { return one.second.interface == interface; });
  if (found == events_.end()) return {};
  return found->second.events;
}

ReplayedComponent::ReplayedComponent(std::string name, std::shared_ptr<ReplayedMembers> members,
                                     const Options& options)
    : Component(std::move(name)), members_(std::move(members)), refused_(this->name()) {
  for (const StateTable* table : members_->tables()) {
    AddColumnReads(*table, AddReservedInterface(table->name()));
  }
  if (options.description != nullptr) {
    period_ = options.description->period;
    for (const ProvidedDescription& provided : options.description->provided) {
      if (!IsStateTable(provided.name)) AddInterface(provided, options);
    }
  }
  for (const std::string& interface : members_->interfaces()) {
    if (FindProvided(interface) == nullptr) AddInterface({interface, {}, {}}, options);
  }
}

void ReplayedComponent::AddInterface(const ProvidedDescription& provided, const Options& options) {
  ProvidedInterface& interface = AddProvidedInterface(provided.name);
  for (const MemberDescription& command : provided.commands) {
    auto read = ReadOf(command, *options.description, members_->tables());
    if (!read) read = std::make_unique<RefusedOffer>(command, options.refusal, refused_);
    interface.AddOffer(std::move(read));
  }
  const auto recorded = members_->EventsOf(provided.name);
  for (const MemberDescription& event : provided.events) {
    if (std::ranges::count(recorded, event.name, &NamedReplayedEvent::name) > 0) continue;
    AddSilentEvent(event, interface);
  }
  for (const auto& [name, type, event] : recorded) {
    interface.AddEvent(*event, DescribeEvent(name, type));
  }
}

/// An event that is not in the recording is never raised.
void ReplayedComponent::AddSilentEvent(const MemberDescription& event,
                                       ProvidedInterface& interface) {
  silent_events_.push_back(std::make_unique<ReplayedEvent>());
  interface.AddEvent(*silent_events_.back(), event);
}

}  // namespace tendon::recording
