#pragma once

#include <tendon/gcm/supervisor/launch_options.h>
#include <tendon/gcm/supervisor/launcher.h>

#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>

namespace tendon::server {

/// Starts each `lcm` in its own session, so that it does not receive the signals of a terminal. For
/// each process, the folder contains a log (NAME.log), and NAME.log.1 with the previous part of the
/// log or the log of the previous run. If the process was started with components, it also contains
/// a system file (NAME.json).
class LcmLauncher final : public Launcher {
 public:
  /// `gcm` is the address of the GCM. Only this user gets access to `folder`.
  LcmLauncher(LaunchOptions launch, const std::string& gcm, std::filesystem::path folder);

  Result<std::shared_ptr<StartedProcess>> Start(const Order& order) override;
  ProcessLog LogOf(const std::string& process) override;
  /// Copies the log and then truncates it. Output that the process writes in between is lost.
  void ShortenLog(const std::string& process) override;

 private:
  void Warn(const std::string& process, const std::string& what);
  [[nodiscard]] std::filesystem::path FileOf(const std::string& process,
                                             const std::string& ending) const;

  const LaunchOptions launch_;
  const std::string gcm_;
  const std::filesystem::path folder_;
  std::set<std::string> shortened_;  // processes whose NAME.log.1 is from the present run
  std::map<std::string, std::string> warnings_;  // last warning about each process; "": none
};

}  // namespace tendon::server
