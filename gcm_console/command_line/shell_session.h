#pragma once

#include <gcm_console/command_line/settings.h>

#include <memory>
#include <string>
#include <utility>

namespace console {

/// The state that is kept from one command line to the next, in the shell and in the console of the
/// window: the default settings, and one link to the GCM.
class ShellSession {
 public:
  explicit ShellSession(Settings settings) : settings_(std::move(settings)) {
    settings_.in_session = true;
  }

  /// The default settings for the next line.
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Sets the path to which relative paths are relative from now on.
  void GoTo(const std::string& path) { settings_.at = path; }

  /// Returns the link; the first call opens it. Does not block until the GCM answers.
  tendon::Result<std::shared_ptr<tendon::GcmClient>> Client();
  /// Returns true if a line with these settings can use the link: it has the same GCM and the same
  /// identity.
  [[nodiscard]] bool Fits(const Settings& settings) const;
  /// Returns the catalogue as far as it was received. Does not block.
  [[nodiscard]] tendon::Catalogue catalogue();

 private:
  Settings settings_;
  std::shared_ptr<tendon::GcmClient> client_;
};

/// Opens a link to the GCM in `settings`. Does not block until the GCM answers.
tendon::Result<std::shared_ptr<tendon::GcmClient>> OpenClient(
    const Settings& settings, const std::string& name,
    std::shared_ptr<tendon::GcmListener> listener = nullptr);

}  // namespace console
