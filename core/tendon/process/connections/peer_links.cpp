#include <tendon/process/connections/peer_links.h>

#include <tendon/process/heartbeat.h>

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

void PeerLinks::Update(const std::vector<ProcessDescription>& processes) {
  endpoints_.clear();
  for (const ProcessDescription& process : processes) {
    Learn(process.name, process.address, process.instance);
  }
  std::erase_if(unresponsive_, [this](const auto& one) { return !endpoints_.contains(one.first); });
}

void PeerLinks::Learn(const std::string& process, const std::string& address,
                      std::uint64_t instance) {
  if (!address.empty()) endpoints_[process] = {address, instance};
}

std::vector<std::string> PeerLinks::names() const {
  std::vector<std::string> names;
  for (const auto& [process, endpoint] : endpoints_) names.push_back(process);
  return names;
}

std::optional<std::uint64_t> PeerLinks::InstanceOf(const std::string& process) const {
  const auto found = endpoints_.find(process);
  if (found == endpoints_.end()) return std::nullopt;
  return found->second.instance;
}

void PeerLinks::LinkTo(const std::string& process, Done done) {
  const auto link = links_.find(process);
  if (link != links_.end() && link->second->channel()->is_open()) return done(link->second);
  const auto endpoint = endpoints_.find(process);
  if (endpoint == endpoints_.end()) return done(NotThere(process));
  const auto peer = unresponsive_.find(process);
  const bool was_silent = peer != unresponsive_.end() && peer->second.endpoint == endpoint->second;
  if (was_silent && SteadyClock().Now() < peer->second.until) return done(peer->second.error);
  std::vector<Done>& waiting = openings_[process];
  waiting.push_back(std::move(done));
  if (waiting.size() > 1) return;
  if (!was_silent) return Open(process);
  unresponsive_queue_.push_back(process);
  if (unresponsive_queue_.size() == 1) Open(process);
}

void PeerLinks::Open(const std::string& process) {
  const auto endpoint = endpoints_.find(process);
  if (endpoint == endpoints_.end()) return Finish(process, {}, NotThere(process));
  PeerLink::Open(context_, listener_, process, endpoint->second.address,
                 [this, process, tried = endpoint->second](const auto& opened) {
                   Finish(process, tried, opened);
                 });
}

void PeerLinks::Finish(const std::string& process, const Endpoint& tried,
                       const Result<std::shared_ptr<PeerLink>>& opened) {
  RecordOutcome(process, tried, opened);
  const auto endpoint = endpoints_.find(process);
  const bool has_moved = endpoint != endpoints_.end() && endpoint->second != tried;
  if (has_moved && !(opened && (*opened)->instance() == endpoint->second.instance)) {
    if (opened) (*opened)->channel()->Close();
    Open(process);
  } else {
    if (opened) links_[process] = *opened;
    const auto ended = openings_.extract(process);
    for (const Done& done : ended.mapped()) done(opened);
  }
  if (unresponsive_queue_.empty() || unresponsive_queue_.front() != process) return;
  unresponsive_queue_.pop_front();
  if (unresponsive_queue_.empty()) return;
  const std::string next = unresponsive_queue_.front();  // a copy: Open() may remove the entry
  Open(next);
}

void PeerLinks::RecordOutcome(const std::string& process, const Endpoint& tried,
                              const Result<std::shared_ptr<PeerLink>>& opened) {
  if (opened || opened.error().code != ErrorCode::kTimeout) {
    unresponsive_.erase(process);
    return;
  }
  UnresponsivePeer& peer = unresponsive_[process];
  if (peer.endpoint != tried) peer.backoff.Reset();
  peer.endpoint = tried;
  peer.error = opened.error();
  peer.until = SteadyClock().Now() + peer.backoff.Next();
}

void PeerLinks::CloseOutdated() {
  for (const auto& [process, link] : links_) {
    const auto instance = InstanceOf(process);
    if (instance && link->instance() != *instance) link->channel()->Close();
    if (instance || !link->channel()->is_open()) continue;
    if (!IsSilent(*link)) continue;  // the process answers; only the GCM has lost it
    link->channel()->CutOff("has not answered for " + std::to_string(Rounded(link->silence())) +
                            " ms, and the GCM has lost this process");
  }
}

void PeerLinks::CloseAll() {
  for (const auto& [process, link] : links_) link->channel()->Close();
  links_.clear();
}

}  // namespace tendon
