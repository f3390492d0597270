#include <gcm_console/verbs/queries.h>

#include <utility>

namespace console {

tendon::message::SystemHealth AskHealth(Context& context) {
  auto health = context.Ask<tendon::message::SystemHealth>(
      [](tendon::GcmClient& client, auto handler) { client.GetHealth(handler); });
  return health ? *std::move(health) : tendon::message::SystemHealth{};
}

std::optional<tendon::ConnectionCounts> AskCounts(Context& context, const PathTarget& target) {
  const tendon::InterfaceName required(target.process->process.name, target.component->name,
                                       target.required->name);
  const auto counts = context.Ask<tendon::ConnectionCounts>(
      [&](tendon::GcmClient& client, auto handler) { client.GetCounts(required, handler); });
  return counts ? std::optional(*counts) : std::nullopt;
}

std::optional<tendon::MailboxFill> AskFill(Context& context, const PathTarget& target) {
  const auto fill = context.Ask<tendon::MailboxFill>([&](tendon::GcmClient& client, auto handler) {
    client.GetFill(target.process->process.name, target.component->name, handler);
  });
  return fill && fill->capacity > 0 ? std::optional(*fill) : std::nullopt;
}

std::optional<tendon::message::ProcessHistoryState> AskHistory(Context& context,
                                                               const std::string& process) {
  const auto history = context.Ask<tendon::message::ProcessHistoryState>(
      [&](tendon::GcmClient& client, auto handler) { client.GetProcessHistory(process, handler); });
  return history ? std::optional(*history) : std::nullopt;
}

tendon::Result<tendon::Schema> AskSchema(Context& context, const std::string& process,
                                         const tendon::Fingerprint& type) {
  return context.Ask<tendon::Schema>([&](tendon::GcmClient& client, auto handler) {
    client.GetSchema(process, type, std::move(handler));
  });
}

tendon::Result<tendon::message::Classes> AskClasses(Context& context, const std::string& process) {
  return context.Ask<tendon::message::Classes>([&](tendon::GcmClient& client, auto handler) {
    client.GetClasses(process, std::move(handler));
  });
}

}  // namespace console
