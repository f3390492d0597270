#pragma once

#include <tendon/gcm/supervisor/launch_options.h>
#include <tendon/gcm/supervisor/launcher.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace tendon::server {

/// Starts `lcm` programs in sessions of their own, so that a terminal's signals do not reach them.
/// For each process, the folder has a log (NAME.log), the earlier log of the process or its
/// predecessor (NAME.log.1), and a system file (NAME.json) if it was started with components.
class LcmLauncher final : public Launcher {
 public:
  /// `gcm` is the address of the GCM; `folder` is private to this user.
  LcmLauncher(LaunchOptions launch, const std::string& gcm, std::filesystem::path folder);

  Result<std::shared_ptr<StartedProcess>> Start(const Order& order) override;
  ProcessLog LogOf(const std::string& process) override;
  /// Output that is written between the copy and the truncation is lost.
  void ShortenLog(const std::string& process) override;

 private:
  void Complain(const std::string& process, const std::string& what);
  [[nodiscard]] std::filesystem::path FileOf(const std::string& process,
                                             const std::string& ending) const;

  const LaunchOptions launch_;
  const std::string gcm_;
  const std::filesystem::path folder_;
  std::set<std::string> shortened_;                // whose NAME.log.1 is from the present run
  std::map<std::string, std::string> complaints_;  // last complaint about each process; "": none
};

}  // namespace tendon::server
