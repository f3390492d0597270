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

/// Nobody who looks from the other side means something else.
Result<void> CheckOrder(const tendon::Catalog& catalog, const InterfaceName& required,
                        const InterfaceName& provided) {
  const bool is_swapped = catalog.FindRequired(required) == nullptr &&
                          catalog.FindProvided(required) != nullptr &&
                          catalog.FindRequired(provided) != nullptr;
  if (!is_swapped) return {};
  return tendon::Error{tendon::ErrorCode::kInvalid,
                       ToString(required) +
                           " is what is provided: the required interface comes "
                           "first; run: gcm connect " +
                           ToString(provided) + " " + ToString(required)};
}

Result<ExitCode> Connect(Context& context, const Ends& ends) {
  const auto required = tendon::ParseInterfaceName(ends.required);
  if (!required) return required.error();
  const auto provided = tendon::ParseInterfaceName(ends.provided);
  if (!provided) return provided.error();
  const auto client = context.Client();
  if (!client) return client.error();
  if (auto good = CheckOrder((*client)->catalog(), *required, *provided); !good) {
    return good.error();
  }
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
                  << (is_said ? "" : ": " + Plain(made->reason)) << '\n';
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

}  // namespace

std::vector<Verb> WireVerbs() {
  return {
      {"connect",
       "connect a required interface to a provided one",
       [](CLI::App& app) -> Verb::Run {
         auto ends = std::make_shared<Ends>();
         Names(app.add_option("required", ends->required, "process/component/interface"),
               WordKind::kRequired)
             ->required();
         Names(app.add_option("provided", ends->provided, "process/component/interface"),
               WordKind::kProvided)
             ->required();
         app.add_flag("--replace", ends->replace,
                      "end what the required interface is connected to, in one step");
         return [ends](Context& context) { return Connect(context, *ends); };
       },
       {"gcm connect desk/teleoperation/Robot robot/arm/Control"}},
      {"disconnect", "end the connection of a required interface",
       [](CLI::App& app) -> Verb::Run {
         auto ends = std::make_shared<Ends>();
         Names(app.add_option("required", ends->required, "process/component/interface"),
               WordKind::kRequired)
             ->required();
         return [ends](Context& context) { return Disconnect(context, *ends); };
       }},
  };
}

}  // namespace console
