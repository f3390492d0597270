#include <tendon/interface/required_interface.h>

#include <tendon/base/text.h>

#include <algorithm>

namespace tendon {

std::size_t RequiredInterface::AddCaller(MemberCaller& caller, MemberDescription description,
                                         SourceLocation location) {
  names_.Add("function", description.name, name_, location);
  callers_.push_back({std::move(description), &caller});
  return callers_.size() - 1;
}

Offer& RequiredInterface::AddOffer(std::unique_ptr<Offer> handler, SourceLocation location) {
  names_.Add("event handler", handler->description().name, name_, location);
  handler->SetComponent(component_);
  handlers_.push_back(std::move(handler));
  return *handlers_.back();
}

void RequiredInterface::Seal() {
  for (const auto& handler : handlers_) {
    if (handler->expiry() == nullptr) continue;
    throw ConfigurationError("event handler '" + handler->description().name + "' of '" + name_ +
                             "' cannot expire: only commands can expire");
  }
  names_.Seal();
}

bool RequiredInterface::TakePeer() noexcept {
  const GuardedPointer<const Peer>::Call call(announced_);
  if (call.get() == nullptr) return false;
  reported_peer_ = call.get()->number;
  generation_.Set(generation_.Get() + 1);
  return true;
}

void RequiredInterface::AdmitPeer() noexcept {
  const GuardedPointer<const Peer>::Call call(announced_);
  const Peer* const peer = call.get();
  if (peer == nullptr || peer->number != reported_peer_) return;
  binding_.SetByCaller(peer->members);
  if (peer->events != nullptr) peer->events->Release();
}

void RequiredInterface::AdmitPeerAtRest() noexcept {
  const Peer* const peer = announced_.Get();
  if (peer == nullptr || callers() == CallerThreads::kManyThreads) return;
  binding_.Exchange(peer->members);
  if (peer->events != nullptr) peer->events->Release();
}

void RequiredInterface::Announce(Peer& peer) {
  peer.number = ++peers_;
  peer_.Set(peer.number);  // before the component sees the peer
  announced_.Exchange(&peer);
  if (has_listener()) return component_->ReportPeerChanged(*this);
  if (TakePeer()) binding_.Exchange(peer.members);
}

void RequiredInterface::Withdraw() noexcept {
  announced_.Exchange(nullptr);  // after this line, no thread can admit the peer
  binding_.Exchange(nullptr);
}

void RequiredInterface::AnnounceNone() {
  peer_.Set(kNoPeer);
  if (has_listener()) component_->ReportPeerChanged(*this);
}

void RequiredInterface::SetMailboxCapacity(std::size_t capacity) {
  constexpr std::size_t kMax = std::size_t{1} << 24U;
  if (capacity < 1 || capacity > kMax) {
    throw ConfigurationError("mailbox capacity of '" + name_ + "' must be 1..16777216, got " +
                             std::to_string(capacity));
  }
  mailbox_capacity_ = capacity;
}

void RequiredInterface::SetReadDeadline(std::chrono::milliseconds deadline) {
  if (deadline < std::chrono::milliseconds(1)) {
    throw ConfigurationError("read deadline of '" + name_ + "' must be at least 1 ms, got " +
                             Milliseconds(deadline));
  }
  read_deadline_ = deadline;
}

void RequiredInterface::MarkMirrored(const MemberCaller& function) {
  const auto found = std::ranges::find(callers_, &function, &NamedCaller::caller);
  if (found == callers_.end()) {
    throw ConfigurationError("'" + name_ +
                             "' mirrors a function that it does not have: add the function first");
  }
  found->is_mirrored = true;
}

std::vector<std::string> RequiredInterface::mirrored() const {
  std::vector<std::string> names;
  for (const NamedCaller& one : callers_) {
    if (one.is_mirrored) names.push_back(one.description.name);
  }
  return names;
}

bool RequiredInterface::handles_in_raiser() const {
  return std::any_of(handlers_.begin(), handlers_.end(), [this](const auto& handler) {
    return handler->RunsInCaller(inbox_ != nullptr);
  });
}

std::vector<std::string> RequiredInterface::latest_only() const {
  std::vector<std::string> names;
  for (const auto& handler : handlers_) {
    if (handler->keeps_latest_only()) names.push_back(handler->description().name);
  }
  return names;
}

RequiredDescription RequiredInterface::description() const {
  RequiredDescription description{
      .name = name_, .functions = {}, .event_handlers = {}, .optional = need_ == Need::kOptional};
  for (const NamedCaller& one : callers_) description.functions.push_back(one.description);
  for (const auto& handler : handlers_) {
    description.event_handlers.push_back(handler->description());
  }
  return description;
}

}  // namespace tendon
