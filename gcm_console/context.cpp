#include <gcm_console/context.h>
#include <program/network_options.h>
#include <tendon/base/os/termination.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <utility>

namespace console {

Context::Context(Settings settings, std::string verb, std::ostream& out, std::ostream& err,
                 int columns)
    : settings_(std::move(settings)),
      verb_(std::move(verb)),
      out_(out),
      err_(err),
      columns_(columns) {}

tendon::Result<tendon::GcmClient*> Context::Client(std::shared_ptr<tendon::GcmListener> listener) {
  if (client_) return client_.get();
  auto made = program::MakeMiddleware(settings_.network);
  if (!made) return made.error();
  auto client = std::make_unique<tendon::GcmClient>(
      *made,
      tendon::GcmClient::Options{
          .name = "gcm " + verb_,
          .address = settings_.gcm,
          .timeout = settings_.timeout,
          .role = settings_.read_only ? tendon::Role::kViewer : tendon::Role::kOperator},
      std::move(listener));
  const tendon::os::TerminationLetThrough impatient;
  if (auto watching = client->WaitUntilWatching(); !watching) return watching.error();
  client_ = std::move(client);
  return client_.get();
}

void Context::PrintJson(const nlohmann::ordered_json& content) const {
  nlohmann::ordered_json document = {{"schema", 1}};
  document.update(content);
  out_ << document.dump(2) << '\n';
}

}  // namespace console
