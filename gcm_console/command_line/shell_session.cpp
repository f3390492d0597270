#include <gcm_console/command_line/shell_session.h>

#include <tendon/base/os/process.h>

#include <utility>

namespace console {

tendon::Result<std::shared_ptr<tendon::GcmClient>> OpenClient(
    const Settings& settings, const std::string& name,
    std::shared_ptr<tendon::GcmListener> listener) {
  if (auto address = program::CheckGcmAddress(settings.gcm, settings.network); !address) {
    return address.error();
  }
  auto middleware = program::MakeMiddleware(settings.network);
  if (!middleware) return middleware.error();
  return std::make_shared<tendon::GcmClient>(
      *middleware,
      tendon::GcmClient::Options{
          .name = name + " of " + tendon::os::UserAtHost(),
          .address = settings.gcm,
          .timeout = settings.timeout,
          .role = settings.read_only ? tendon::Role::kViewer : tendon::Role::kOperator},
      std::move(listener));
}

tendon::Result<std::shared_ptr<tendon::GcmClient>> ShellSession::Client() {
  if (client_) return client_;
  auto opened = OpenClient(settings_, "gcm shell");
  if (opened) client_ = *opened;
  return opened;
}

bool ShellSession::Fits(const Settings& settings) const {
  return settings.gcm == settings_.gcm && settings.read_only == settings_.read_only &&
         settings.timeout == settings_.timeout && settings.network == settings_.network;
}

tendon::Catalogue ShellSession::catalogue() {
  const auto client = Client();
  return client ? (*client)->catalogue() : tendon::Catalogue();
}

}  // namespace console
