#include <tendon/recording/replayed_component.h>

#include <tendon/interface/column_offer.h>
#include <tendon/interface/observed_call.h>

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

  Status ExecuteEncoded(std::span<const std::byte> /*in*/, ReplySink& /*out*/) override {
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

/// Returns the names of the table and the column if the description of the component has exactly
/// one column of this type. This column may not be recorded.
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

/// Returns a read of the column whose value the read command probably returns; null if there is no
/// such column.
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

/// As the calls of a command describe it.
MemberDescription DescribeCommand(const std::string& name, const Schema& calls) {
  const Schema argument = ArgumentOfCalls(calls);
  const Schema result = ResultOfCalls(calls);
  const CommandKind kind =
      !result.is_none()
          ? (argument.is_none() ? CommandKind::kVoidReturn : CommandKind::kWriteReturn)
          : (argument.is_none() ? CommandKind::kVoid : CommandKind::kWrite);
  MemberDescription description = DescribeMember<None, None>(name, kind);
  description.signature.in = payload::Remember(argument);
  description.in_type = argument.TypeName();
  description.signature.out = payload::Remember(result);
  description.out_type = result.TypeName();
  return description;
}

/// True if these are calls of this command.
bool IsOf(const MemberDescription& command, const NamedReplayedCommand& recorded) {
  const MemberDescription calls = DescribeCommand(recorded.name, recorded.type);
  return command.name == recorded.name && command.signature == calls.signature;
}

}  // namespace

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
  const auto calls = members_->CommandsOf(provided.name);
  for (const MemberDescription& command : provided.commands) {
    auto offer = ReadOf(command, *options.description, members_->tables());
    if (!offer) offer = std::make_unique<RefusedOffer>(command, options.refusal, refused_);
    const auto shown = std::ranges::find_if(
        calls, [&](const NamedReplayedCommand& one) { return IsOf(command, one); });
    if (shown != calls.end()) offer->SetCalls(shown->calls);
    interface.AddOffer(std::move(offer));
  }
  for (const NamedReplayedCommand& one : calls) {
    const bool is_described =
        std::ranges::count(provided.commands, one.name, &MemberDescription::name) > 0;
    if (is_described) continue;
    auto offer = std::make_unique<RefusedOffer>(DescribeCommand(one.name, one.type),
                                                options.refusal, refused_);
    offer->SetCalls(one.calls);
    interface.AddOffer(std::move(offer));
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
