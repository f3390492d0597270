#include <gcm_console/report.h>
#include <gcm_console/verb.h>
#include <tendon/gcm/lookup.h>

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

/// The connection waits for a process that nobody has ever seen, perhaps because it is misspelt.
ExitCode WarnOfUnknown(Context& context, const tendon::Error& unknown, const Ends& ends) {
  const bool asks = unknown.message.ends_with("?");
  context.err() << "gcm: " << Plain(unknown.message) << (asks ? " " : "; ")
                << "the connection waits for it; take it back: gcm disconnect " << ends.required
                << '\n';
  return program::kNotFound;
}

Result<ExitCode> Connect(Context& context, const Ends& ends) {
  const auto required = tendon::ParseInterfaceName(ends.required);
  if (!required) return required.error();
  const auto provided = tendon::ParseInterfaceName(ends.provided);
  if (!provided) return provided.error();
  const auto client = context.Client();
  if (!client) return client.error();
  const auto made = context.Ask<tendon::ConnectionDescription>(
      [&](tendon::GcmClient& asked, auto handler) {
        if (ends.replace) {
          asked.Replace(*required, *provided, handler);
        } else {
          asked.Connect(*required, *provided, handler);
        }
      },
      tendon::GcmClient::kOrdersOfAReplacement);
  if (!made) return made.error();
  const tendon::Catalog catalog = (*client)->catalog();
  const auto provider = LookUpProcess(catalog, provided->process);
  const bool is_unknown = !provider && made->state == tendon::ConnectionState::kPending;
  const std::string state(tendon::ToString(made->state));
  if (context.settings().json) {
    context.PrintJson({{"id", made->id},
                       {"required", ToString(made->required)},
                       {"provided", ToString(made->provided)},
                       {"state", state},
                       {"reason", made->reason}});
  } else {
    const bool is_said = is_unknown || made->reason.empty();
    context.out() << ToString(made->required) << " -> " << ToString(made->provided) << "  " << state
                  << (is_said ? "" : ": " + made->reason) << '\n';
  }
  return is_unknown ? WarnOfUnknown(context, provider.error(), ends) : program::kOk;
}

Result<ExitCode> Disconnect(Context& context, const Ends& ends) {
  const auto required = tendon::ParseInterfaceName(ends.required);
  if (!required) return required.error();
  const auto done = context.Ask<void>(
      [&](tendon::GcmClient& client, auto handler) { client.Disconnect(*required, handler); });
  if (!done) return done.error();
  if (context.settings().json) {
    context.PrintJson({{"required", ToString(*required)}});
  } else {
    context.out() << ToString(*required) << "  disconnected\n";
  }
  return program::kOk;
}

Result<ExitCode> Undo(Context& context) {
  const auto undone = context.Ask<tendon::message::HistoryEntry>(
      [](tendon::GcmClient& client, auto handler) { client.Undo(handler); },
      tendon::GcmClient::kOrdersOfAReplacement);
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
