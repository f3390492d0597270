#include <gcm_console/verb.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

using program::ExitCode;
using tendon::InterfaceName;
using tendon::Result;

struct Ends {
  std::string required;
  std::string provided;
  bool replace = false;
};

Result<ExitCode> Connect(Context& context, const Ends& ends) {
  const auto required = tendon::ParseInterfaceName(ends.required);
  if (!required) return required.error();
  const auto provided = tendon::ParseInterfaceName(ends.provided);
  if (!provided) return provided.error();
  const auto client = context.Client();
  if (!client) return client.error();
  const auto made =
      tendon::Wait<tendon::ConnectionDescription>(context.settings().timeout, [&](auto handler) {
        if (ends.replace) {
          (*client)->Replace(*required, *provided, handler);
        } else {
          (*client)->Connect(*required, *provided, handler);
        }
      });
  if (!made) return made.error();
  const std::string state(tendon::ToString(made->state));
  if (context.settings().json) {
    context.PrintJson({{"id", made->id},
                       {"required", ToString(made->required)},
                       {"provided", ToString(made->provided)},
                       {"state", state},
                       {"reason", made->reason}});
  } else {
    context.out() << ToString(made->required) << " -> " << ToString(made->provided) << "  " << state
                  << (made->reason.empty() ? "" : ": " + made->reason) << '\n';
  }
  return program::kOk;
}

Result<ExitCode> Disconnect(Context& context, const Ends& ends) {
  const auto required = tendon::ParseInterfaceName(ends.required);
  if (!required) return required.error();
  const auto client = context.Client();
  if (!client) return client.error();
  const auto done = tendon::Wait<void>(
      context.settings().timeout, [&](auto handler) { (*client)->Disconnect(*required, handler); });
  if (!done) return done.error();
  if (context.settings().json) {
    context.PrintJson({{"required", ToString(*required)}});
  } else {
    context.out() << ToString(*required) << "  disconnected\n";
  }
  return program::kOk;
}

Result<ExitCode> Undo(Context& context) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto undone = tendon::Wait<tendon::message::HistoryEntry>(
      context.settings().timeout, [&](auto handler) { (*client)->Undo(handler); });
  if (!undone) return undone.error();
  const std::string required = ToString(undone->wire.required);
  const std::string provided = ToString(undone->wire.provided);
  const bool was_replaced = undone->verb == "replace";
  if (context.settings().json) {
    nlohmann::ordered_json content = {
        {"undone", undone->verb}, {"required", required}, {"provided", provided}};
    if (was_replaced) content["former"] = ToString(undone->former);
    context.PrintJson(content);
  } else {
    context.out() << "undone: " << undone->verb << ' ' << required << ' ' << provided
                  << (was_replaced ? "; it is connected to " + ToString(undone->former) : "")
                  << '\n';
  }
  return program::kOk;
}

}  // namespace

std::vector<Verb> WireVerbs() {
  return {
      {"connect", "connect a required interface to a provided one",
       [](CLI::App& app) -> Verb::Run {
         auto ends = std::make_shared<Ends>();
         app.add_option("required", ends->required, "process/component/interface")->required();
         app.add_option("provided", ends->provided, "process/component/interface")->required();
         app.add_flag("--replace", ends->replace,
                      "end what the required interface is connected to, in one step");
         return [ends](Context& context) { return Connect(context, *ends); };
       }},
      {"disconnect", "end the connection of a required interface",
       [](CLI::App& app) -> Verb::Run {
         auto ends = std::make_shared<Ends>();
         app.add_option("required", ends->required, "process/component/interface")->required();
         return [ends](Context& context) { return Disconnect(context, *ends); };
       }},
      {"undo", "take back the last change of the system's connections",
       [](CLI::App&) -> Verb::Run { return &Undo; }},
  };
}

}  // namespace console
