#pragma once

#include <tendon/gcm/supervisor/launch.h>
#include <tendon/gcm/supervisor/launcher.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace tendon::server {

/// Starts `lcm` programs in sessions of their own, so that a terminal's signals do not reach them.
/// The folder has, for each, a log (NAME.log), the earlier log of it or its predecessor
/// (NAME.log.1), and, if it was started with components, their system file (NAME.json).
class LcmLauncher final : public Launcher {
 public:
  /// `gcm` is the address of the GCM; `folder` is private to this user.
  LcmLauncher(Launch launch, const std::string& gcm, std::filesystem::path folder);

  Result<std::shared_ptr<StartedProcess>> Start(const Order& order) override;
  Traces TracesOf(const std::string& process) override;
  /// Loses what is written between the copy and the truncation.
  void ShortenLog(const std::string& process) override;

 private:
  void Complain(const std::string& process, const std::string& what);
  [[nodiscard]] std::filesystem::path FileOf(const std::string& process,
                                             const std::string& ending) const;

  const Launch launch_;
  const std::string gcm_;
  const std::filesystem::path folder_;
  std::set<std::string> shortened_;                // those whose earlier log is their own
  std::map<std::string, std::string> complaints_;  // last complaint about each process; "": none
};

}  // namespace tendon::server
