#include <tendon/gcm/members/connection_restorer.h>

#include <tendon/gcm/lookup.h>

#include <algorithm>

namespace tendon::server {
namespace {

std::string ClassOf(const Catalogue& catalogue, const InterfaceName& end) {
  const ComponentDescription* component = catalogue.FindComponent(end.process, end.component);
  return component == nullptr ? std::string() : component->class_name;
}

}  // namespace

void ConnectionRestorer::Keep(const Catalogue& catalogue, const std::string& process) {
  const ProcessEntry* entry = catalogue.FindProcess(process);
  if (entry == nullptr) return;
  for (const auto& [id, connection] : entry->connections) {
    std::erase_if(kept_, [&required = connection.required](const WaitingConnection& kept) {
      return kept.ends.required == required;
    });
    kept_.push_back({{connection.required, connection.provided},
                     ClassOf(catalogue, connection.required),
                     ClassOf(catalogue, connection.provided)});
  }
}

void ConnectionRestorer::Drop(const std::string& process) {
  std::erase_if(
      kept_, [&](const WaitingConnection& kept) { return kept.ends.required.process == process; });
}

std::vector<message::ConnectionEnds> ConnectionRestorer::TakeDue(const Catalogue& catalogue,
                                                                 SteadyTime now) {
  std::vector<message::ConnectionEnds> due;
  std::erase_if(kept_, [&](WaitingConnection& kept) {
    if (kept.is_ordered || now < kept.not_before) return false;
    const Readiness readiness = Judge(kept, catalogue);
    kept.is_ordered = readiness == Readiness::kDue;
    if (kept.is_ordered) due.push_back(kept.ends);
    return readiness == Readiness::kPointless;
  });
  return due;
}

ConnectionRestorer::Verdict ConnectionRestorer::Settle(const message::ConnectionEnds& ends,
                                                       const Result<void>& outcome,
                                                       SteadyTime now) {
  const auto kept = std::find_if(kept_.begin(), kept_.end(), [&](const WaitingConnection& one) {
    return one.is_ordered && one.ends == ends;
  });
  if (kept == kept_.end() || outcome || IsFinal(outcome.error().code)) {
    if (kept != kept_.end()) kept_.erase(kept);
    return outcome ? Verdict::kDone : Verdict::kGivenUp;
  }
  const bool is_first = !kept->backoff.has_begun();
  kept->is_ordered = false;
  kept->not_before = now + kept->backoff.Next();
  return is_first ? Verdict::kTryAgain : Verdict::kStillTrying;
}

bool ConnectionRestorer::IsPauseOver(SteadyTime now) const {
  return std::any_of(kept_.begin(), kept_.end(), [&](const WaitingConnection& kept) {
    return !kept.is_ordered && kept.backoff.has_begun() && kept.not_before <= now;
  });
}

ConnectionRestorer::Readiness ConnectionRestorer::Judge(const WaitingConnection& kept,
                                                        const Catalogue& catalogue) {
  const auto& [required, provided] = kept.ends;
  const ProcessEntry* owner = catalogue.FindProcess(required.process);
  if (owner == nullptr || !IsPresent(owner->process)) return Readiness::kWaiting;
  if (catalogue.FindConnection(required) != nullptr) return Readiness::kPointless;
  if (catalogue.FindRequired(required) == nullptr || catalogue.FindProvided(provided) == nullptr) {
    return Readiness::kWaiting;
  }
  const bool same_classes =
      ClassOf(catalogue, required) == kept.required_class &&
      (kept.provided_class.empty() || ClassOf(catalogue, provided) == kept.provided_class);
  return same_classes ? Readiness::kDue : Readiness::kPointless;
}

}  // namespace tendon::server
