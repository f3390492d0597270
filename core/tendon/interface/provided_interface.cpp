#include <tendon/interface/provided_interface.h>

#include <algorithm>

namespace tendon {

Offer& ProvidedInterface::AddOffer(std::unique_ptr<Offer> offer, SourceLocation location) {
  names_.Add("command", offer->description().name, name_, location);
  offer->SetComponent(component_);
  commands_.push_back(std::move(offer));
  return *commands_.back();
}

void ProvidedInterface::AddEvent(EventBase& event, MemberDescription description,
                                 SourceLocation location) {
  names_.Add("event", description.name, name_, location);
  event.SetRaisers(raisers(), inbox_);
  events_.push_back({std::move(description), &event});
}

const Offer* ProvidedInterface::FindCommand(const std::string& name) const {
  const auto found = std::find_if(commands_.begin(), commands_.end(), [&name](const auto& offer) {
    return offer->description().name == name;
  });
  return found == commands_.end() ? nullptr : found->get();
}

EventBase* ProvidedInterface::FindEvent(const std::string& name) const {
  const auto found = std::find_if(events_.begin(), events_.end(), [&name](const NamedEvent& one) {
    return one.description.name == name;
  });
  return found == events_.end() ? nullptr : found->event;
}

EventBase* ProvidedInterface::ObserveCalls(const std::string& name) {
  for (const auto& offer : commands_) {
    const MemberDescription& command = offer->description();
    if (command.name != name || !CanBeObserved(command.signature)) continue;
    return &offer->ObserveCalls(inbox_);
  }
  return nullptr;
}

void ProvidedInterface::SetSourceFaulted(bool faulted) {
  for (const NamedEvent& one : events_) one.event->SetSourceFaulted(faulted);
}

std::vector<std::string> ProvidedInterface::latest_only() const {
  std::vector<std::string> names;
  for (const auto& offer : commands_) {
    if (offer->keeps_latest_only()) names.push_back(offer->description().name);
  }
  return names;
}

std::vector<Expiry*> ProvidedInterface::expiries() const {
  std::vector<Expiry*> all;
  for (const auto& offer : commands_) {
    if (offer->expiry() != nullptr) all.push_back(offer->expiry());
  }
  return all;
}

ProvidedDescription ProvidedInterface::description() const {
  ProvidedDescription description{.name = name_, .commands = {}, .events = {}};
  for (const auto& offer : commands_) description.commands.push_back(offer->description());
  for (const NamedEvent& one : events_) description.events.push_back(one.description);
  return description;
}

ProvidedDescription ProvidedInterface::description_for_observers() const {
  ProvidedDescription all = description();
  for (const MemberDescription& command : all.commands) {
    if (CanBeObserved(command.signature)) all.events.push_back(DescribeCalls(command));
  }
  return all;
}

}  // namespace tendon
