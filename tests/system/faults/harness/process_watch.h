#pragma once

#include <tendon/gcm/client.h>

#include <cstddef>
#include <map>
#include <mutex>
#include <string>
#include <vector>

namespace faults {

/// Records which processes were seen under each name, in the order of the catalogue's changes.
class ProcessWatch final : public tendon::GcmListener {
 public:
  /// Returns how often the process entered this state.
  [[nodiscard]] std::size_t Count(const std::string& process, tendon::ProcessState state) const;
  /// Returns the names that a second instance took while the first instance was still alive in the
  /// catalogue.
  [[nodiscard]] std::vector<std::string> double_holders() const;
  [[nodiscard]] std::size_t snapshots() const;
  /// Returns the number of reported changes of a connection.
  [[nodiscard]] std::size_t connection_changes() const;

 private:
  void OnSnapshot(const tendon::Catalogue& catalogue) override;
  void OnChanges(const std::vector<tendon::CatalogueChange>& changes) override;
  void OnGcmLost(const tendon::Error& reason) override;
  void See(const tendon::ProcessDescription& process);

  mutable std::mutex mutex_;
  std::map<std::string, tendon::ProcessDescription> last_;
  std::map<std::pair<std::string, tendon::ProcessState>, std::size_t> counts_;
  std::vector<std::string> double_holders_;
  std::size_t snapshots_ = 0;
  std::size_t connection_changes_ = 0;
};

}  // namespace faults
