#pragma once

#include <tendon/gcm/supervisor/launch.h>
#include <tendon/gcm/supervisor/launcher.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace tendon::server {

/// Starts `lcm` programs, in sessions of their own: what a terminal sends to us does not reach
/// them. Each has in the folder a log (NAME.log), what was written before it (NAME.log.1), by
/// itself or by its predecessor, and, where it was started with components, their system file
/// (NAME.json).
class LcmLauncher final : public Launcher {
 public:
  /// `gcm` is where a GCM listens, `folder` of this user alone.
  LcmLauncher(Launch launch, const std::string& gcm, std::filesystem::path folder);

  Result<std::shared_ptr<StartedProcess>> Start(const Order& order) override;
  Traces TracesOf(const std::string& process) override;
  /// What is written between the copy and the cut is lost.
  void ShortenLog(const std::string& process) override;

 private:
  void Complain(const std::string& process, const std::string& what);
  [[nodiscard]] std::filesystem::path FileOf(const std::string& process,
                                             const std::string& ending) const;

  const Launch launch_;
  const std::string gcm_;
  const std::filesystem::path folder_;
  std::set<std::string> shortened_;                // whose former log is its own
  std::map<std::string, std::string> complaints_;  // the last of each process; "": all is well
};

}  // namespace tendon::server
