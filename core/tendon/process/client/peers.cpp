#include <tendon/process/client/peers.h>

namespace tendon {

void Peers::Update(const std::vector<ProcessDescription>& processes) {
  places_.clear();
  for (const ProcessDescription& process : processes) {
    Learn(process.name, process.address, process.instance);
  }
}

void Peers::Learn(const std::string& process, const std::string& address, std::uint64_t instance) {
  if (!address.empty()) places_[process] = {address, instance};
}

std::vector<std::string> Peers::names() const {
  std::vector<std::string> names;
  for (const auto& [process, place] : places_) names.push_back(process);
  return names;
}

std::optional<std::uint64_t> Peers::InstanceOf(const std::string& process) const {
  const auto found = places_.find(process);
  if (found == places_.end()) return std::nullopt;
  return found->second.instance;
}

Result<std::shared_ptr<PeerLink>> Peers::LinkTo(const std::string& process) {
  std::shared_ptr<PeerLink>& link = links_[process];
  if (link && link->channel()->is_open()) return link;
  const auto place = places_.find(process);
  if (place == places_.end()) {
    return Error{ErrorCode::kNotFound, "process '" + process + "' is not there"};
  }
  constexpr std::chrono::milliseconds kPause(1000);
  const std::string& address = place->second.address;
  Silence& silence = silences_[process];
  if (silence.address == address && SteadyClock().Now() < silence.until) return silence.error;
  auto opened = PeerLink::Open(context_, listener_, process, address);
  if (opened) {
    link = *opened;
  } else if (opened.error().code == ErrorCode::kTimeout) {
    silence = {address, SteadyClock().Now() + kPause, opened.error()};
  }
  return opened;
}

void Peers::CloseOutdated() {
  for (const auto& [process, link] : links_) {
    const auto instance = InstanceOf(process);
    if (link && instance && link->instance() != *instance) link->channel()->Close();
  }
}

void Peers::CloseAll() {
  for (const auto& [process, link] : links_) {
    if (link) link->channel()->Close();
  }
  links_.clear();
}

}  // namespace tendon
