#include <tendon/process/client/peers.h>
#include <tendon/process/watch_over.h>

#include <algorithm>
#include <string>
#include <utility>

namespace tendon {
namespace {

Error NotThere(const std::string& process) {
  return {ErrorCode::kNotFound, "process '" + process + "' is not available"};
}

std::int64_t Rounded(std::chrono::nanoseconds time) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time).count();
}

/// True if more than one ping is unanswered, and no large message can be the reason.
bool IsSilent(const PeerLink& link) {
  constexpr std::chrono::milliseconds kMoreThanOneQuestion(750);
  return link.silence() > kMoreThanOneQuestion &&
         !MayBeHeldUp(*link.channel(), SteadyClock().Now(), kMoreThanOneQuestion);
}

}  // namespace

void Peers::Update(const std::vector<ProcessDescription>& processes) {
  places_.clear();
  for (const ProcessDescription& process : processes) {
    Learn(process.name, process.address, process.instance);
  }
  std::erase_if(silences_, [this](const auto& one) { return !places_.contains(one.first); });
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

void Peers::LinkTo(const std::string& process, Done done) {
  const auto link = links_.find(process);
  if (link != links_.end() && link->second->channel()->is_open()) return done(link->second);
  const auto place = places_.find(process);
  if (place == places_.end()) return done(NotThere(process));
  const auto silence = silences_.find(process);
  const bool was_silent = silence != silences_.end() && silence->second.place == place->second;
  if (was_silent && SteadyClock().Now() < silence->second.until) return done(silence->second.error);
  std::vector<Done>& waiting = openings_[process];
  waiting.push_back(std::move(done));
  if (waiting.size() > 1) return;
  if (!was_silent) return Open(process);
  silent_.push_back(process);
  if (silent_.size() == 1) Open(process);
}

void Peers::Open(const std::string& process) {
  const auto place = places_.find(process);
  if (place == places_.end()) return Finish(process, {}, NotThere(process));
  PeerLink::Open(context_, listener_, process, place->second.address,
                 [this, process, tried = place->second](const auto& opened) {
                   Finish(process, tried, opened);
                 });
}

void Peers::Finish(const std::string& process, const Place& tried,
                   const Result<std::shared_ptr<PeerLink>>& opened) {
  Remember(process, tried, opened);
  const auto place = places_.find(process);
  const bool has_moved = place != places_.end() && place->second != tried;
  if (has_moved && !(opened && (*opened)->instance() == place->second.instance)) {
    if (opened) (*opened)->channel()->Close();
    Open(process);
  } else {
    if (opened) links_[process] = *opened;
    const auto ended = openings_.extract(process);
    for (const Done& done : ended.mapped()) done(opened);
  }
  if (silent_.empty() || silent_.front() != process) return;
  silent_.pop_front();
  if (silent_.empty()) return;
  const std::string next = silent_.front();  // a copy: Open() may remove the entry
  Open(next);
}

void Peers::Remember(const std::string& process, const Place& tried,
                     const Result<std::shared_ptr<PeerLink>>& opened) {
  constexpr std::chrono::milliseconds kShortestRest(500);
  constexpr std::chrono::milliseconds kLongestRest(1500);  // at most the pause of connections
  if (opened || opened.error().code != ErrorCode::kTimeout) {
    silences_.erase(process);
    return;
  }
  Silence& silence = silences_[process];
  const auto last = silence.place == tried ? silence.rest : std::chrono::milliseconds(0);
  const auto rest = std::clamp(2 * last, kShortestRest, kLongestRest);
  silence = {tried, opened.error(), rest, SteadyClock().Now() + rest};
}

void Peers::CloseOutdated() {
  for (const auto& [process, link] : links_) {
    const auto instance = InstanceOf(process);
    if (instance && link->instance() != *instance) link->channel()->Close();
    if (instance || !link->channel()->is_open()) continue;
    if (!IsSilent(*link)) continue;  // the process answers; only the GCM has lost it
    link->channel()->CutOff("has not answered for " + std::to_string(Rounded(link->silence())) +
                            " ms, and its GCM has lost it");
  }
}

void Peers::CloseAll() {
  for (const auto& [process, link] : links_) link->channel()->Close();
  links_.clear();
}

}  // namespace tendon
