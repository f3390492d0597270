#pragma once

#include <gcm_console/line/settings.h>

#include <memory>
#include <string>

namespace console {

/// What stays from one command line to the next, in the shell and in the window's console: what
/// holds unless a line says otherwise, and one link to the GCM.
class Session {
 public:
  explicit Session(Settings settings) : settings_(std::move(settings)) {
    settings_.in_session = true;
  }

  /// What holds for the next line.
  [[nodiscard]] const Settings& settings() const { return settings_; }
  /// Paths begin there from now on.
  void GoTo(const std::string& path) { settings_.at = path; }

  /// The one link, opened at the first call. Does not wait for the GCM.
  tendon::Result<std::shared_ptr<tendon::GcmClient>> Client();
  /// Whether a line with these settings means our GCM, and us.
  [[nodiscard]] bool Fits(const Settings& settings) const;
  /// As the GCM says, as far as is known without waiting for it.
  [[nodiscard]] tendon::Catalog catalog();

 private:
  Settings settings_;
  std::shared_ptr<tendon::GcmClient> client_;
};

/// Opens a link to the GCM of these settings, without waiting for it.
tendon::Result<std::shared_ptr<tendon::GcmClient>> OpenClient(
    const Settings& settings, const std::string& name,
    std::shared_ptr<tendon::GcmListener> listener = nullptr);

}  // namespace console
