#include "system/faults/harness/process_watch.h"

#include <tendon/gcm/lookup.h>

namespace faults {

std::size_t ProcessWatch::Count(const std::string& process, tendon::ProcessState state) const {
  const std::scoped_lock lock(mutex_);
  const auto found = counts_.find({process, state});
  return found == counts_.end() ? 0 : found->second;
}

std::vector<std::string> ProcessWatch::double_holders() const {
  const std::scoped_lock lock(mutex_);
  return double_holders_;
}

std::size_t ProcessWatch::snapshots() const {
  const std::scoped_lock lock(mutex_);
  return snapshots_;
}

std::size_t ProcessWatch::connection_changes() const {
  const std::scoped_lock lock(mutex_);
  return connection_changes_;
}

void ProcessWatch::OnSnapshot(const tendon::Catalogue& catalogue) {
  const std::scoped_lock lock(mutex_);
  ++snapshots_;
  last_.clear();  // changes between two snapshots were not seen
  for (const auto& [name, entry] : catalogue.processes()) See(entry.process);
}

void ProcessWatch::OnChanges(const std::vector<tendon::CatalogueChange>& changes) {
  const std::scoped_lock lock(mutex_);
  for (const auto& change : changes) {
    for (const auto& process : change.processes) See(process);
    connection_changes_ += change.connections.size();
  }
}

void ProcessWatch::OnGcmLost(const tendon::Error& /*reason*/) {}

void ProcessWatch::See(const tendon::ProcessDescription& process) {
  const auto before = last_.find(process.name);
  const bool is_known = before != last_.end();
  if (is_known && before->second.instance == process.instance &&
      before->second.state == process.state) {
    return;
  }
  if (is_known && before->second.instance != process.instance && IsPresent(before->second)) {
    double_holders_.push_back(process.name);
  }
  ++counts_[{process.name, process.state}];
  last_[process.name] = process;
}

}  // namespace faults
