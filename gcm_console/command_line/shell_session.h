#pragma once

#include <gcm_console/command_line/settings.h>

#include <memory>
#include <string>

namespace console {

/// The state that lasts from one command line to the next, in the shell and in the window's
/// console: the default settings and one link to the GCM.
class ShellSession {
 public:
  explicit ShellSession(Settings settings) : settings_(std::move(settings)) {
    settings_.in_session = true;
  }

  /// The default settings of the next line.
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Sets the path at which relative paths begin from now on.
  void GoTo(const std::string& path) { settings_.at = path; }

  /// The link, opened by the first call. Does not wait for the GCM.
  tendon::Result<std::shared_ptr<tendon::GcmClient>> Client();
  /// True if a line with these settings uses the same GCM and the same identity.
  [[nodiscard]] bool Fits(const Settings& settings) const;
  /// The catalogue as received so far; does not wait for the GCM.
  [[nodiscard]] tendon::Catalogue catalogue();

 private:
  Settings settings_;
  std::shared_ptr<tendon::GcmClient> client_;
};

/// Opens a link to the GCM in `settings` without waiting for it.
tendon::Result<std::shared_ptr<tendon::GcmClient>> OpenClient(
    const Settings& settings, const std::string& name,
    std::shared_ptr<tendon::GcmListener> listener = nullptr);

}  // namespace console
