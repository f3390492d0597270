#include <gcm_console/catalogue/glob.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/connection_checks.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/gcm/interface_matching.h>
#include <tendon/gcm/lookup.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

using program::ExitCode;
using tendon::Catalogue;
using tendon::Error;
using tendon::ErrorCode;
using tendon::InterfaceName;
using tendon::Match;
using tendon::Result;
using tendon::WhenConnected;

struct ConnectArguments {
  std::string required;
  std::string provided;
  bool replace = false;
  bool match = false;
  bool dry_run = false;
  bool yes = false;

  [[nodiscard]] WhenConnected when_connected() const {
    return replace ? WhenConnected::kReplace : WhenConnected::kRefuse;
  }
};

std::string EndsText(const InterfaceName& required, const InterfaceName& provided) {
  return ToString(required) + " -> " + ToString(provided);
}

/// Warns that the connection waits for an unknown process, because its name may be wrong.
ExitCode WarnOfUnknown(Context& context, const tendon::Error& unknown,
                       const ConnectArguments& ends) {
  const bool asks = unknown.message.ends_with("?");
  context.err()
      << "gcm: " << Plain(unknown.message) << (asks ? " " : "; ")
      << (ends.dry_run
              ? "the connection would wait for this process"
              : "the connection waits for this process; to cancel the connection: gcm disconnect " +
                    ends.required)
      << '\n';
  return program::kNotFound;
}

Result<tendon::ConnectionDescription> SendConnect(Context& context, const InterfaceName& required,
                                                  const InterfaceName& provided,
                                                  WhenConnected when_connected) {
  return context.Ask<tendon::ConnectionDescription>(
      [&](tendon::GcmClient& asked, auto handler) {
        asked.Connect(required, provided, handler, when_connected);
      },
      tendon::GcmClient::kReplaceTimeouts);
}

/// Checks what PlanConnect() checks, but makes no plan.
Result<void> CheckConnect(const Catalogue& catalogue, const InterfaceName& required,
                          const InterfaceName& provided, WhenConnected when_connected) {
  const auto plan = PlanConnect(catalogue, {required, provided}, when_connected);
  return plan ? Result<void>() : plan.error();
}

ExitCode Print(Context& context, const VerbForms& forms, const std::vector<Outcome>& outcomes) {
  PrintOutcomes(context, forms, outcomes);
  return ExitCodeOf(outcomes);
}

/// Returns the error for an interface without a match.
Error Unmatched(const Match& match, const std::string& pattern) {
  if (match.provided.empty()) {
    return {ErrorCode::kIncompatible, "no interface that matches '" + pattern +
                                          "' can be connected to this required interface; to list "
                                          "the possible interfaces: gcm candidates " +
                                          ToString(match.required)};
  }
  std::string all;
  for (const InterfaceName& one : match.provided) {
    all += (all.empty() ? "" : ", ") + ToString(one);
  }
  return {ErrorCode::kNotFound,
          std::to_string(match.provided.size()) + " interfaces match equally well: " + all};
}

bool IsClear(const Match& match) { return match.provided.size() == 1; }

std::string PathOf(const Match& match) {
  return IsClear(match) ? EndsText(match.required, match.provided.front())
                        : ToString(match.required);
}

/// Returns the question that the user must confirm before several interfaces are connected at once.
/// Empty if there is only one interface.
std::string QuestionOf(const std::vector<Match>& matches) {
  std::string question;
  std::size_t count = 0;
  for (const Match& match : matches) {
    if (!IsClear(match)) continue;
    question += (count++ == 0 ? " " : ", ") + PathOf(match);
  }
  return count < 2 ? "" : "connect " + std::to_string(count) + " interfaces:" + question;
}

Result<ExitCode> ConnectMatching(Context& context, const ConnectArguments& ends) {
  if (ends.replace) {
    return Error{
        ErrorCode::kInvalid,
        "--match and --replace cannot be used together: --match connects only free interfaces"};
  }
  const auto client = context.Client();
  if (!client) return client.error();
  if (ends.dry_run) LearnConflictingTypes(context);
  const Catalogue catalogue = (*client)->catalogue();
  const auto matches = MatchInterfaces(catalogue, {ends.required, ends.provided});
  if (!matches) return matches.error();
  if (matches->empty()) {
    context.err() << "gcm: all interfaces that '" << Plain(ends.required)
                  << "' matches are already connected\n";
  }
  const std::string question = QuestionOf(*matches);
  if (!ends.dry_run && !ends.yes && !question.empty() && !Confirm(context, question)) {
    return Declined();
  }
  std::vector<Outcome> outcomes;
  for (const Match& match : *matches) {
    Result<void> result;
    if (!IsClear(match)) {
      result = Unmatched(match, ends.provided);
    } else if (ends.dry_run) {
      result =
          CheckConnect(catalogue, match.required, match.provided.front(), ends.when_connected());
    } else if (auto made = SendConnect(context, match.required, match.provided.front(),
                                       ends.when_connected());
               !made) {
      result = made.error();
    }
    outcomes.push_back({PathOf(match), std::move(result)});
  }
  return Print(context, {"connect", "connected", ends.dry_run}, outcomes);
}

Result<ExitCode> Connect(Context& context, const ConnectArguments& ends) {
  if (auto allowed = CheckRole(context); ends.dry_run && !allowed) return allowed.error();
  if (ends.match) return ConnectMatching(context, ends);
  for (const std::string& end : {ends.required, ends.provided}) {
    if (IsGlob(end)) return NoGlobAllowed("gcm connect without --match", end);
  }
  const auto required = tendon::ParseInterfaceName(ends.required);
  if (!required) return required.error();
  const auto provided = tendon::ParseInterfaceName(ends.provided);
  if (!provided) return provided.error();
  const auto client = context.Client();
  if (!client) return client.error();
  if (auto good = CheckOrder("connect", (*client)->catalogue(), *required, *provided); !good) {
    return good.error();
  }
  if (ends.dry_run) {
    LearnConflictingTypes(context);
    auto checked =
        CheckConnect((*client)->catalogue(), *required, *provided, ends.when_connected());
    if (!checked) return checked.error();
    const ExitCode printed =
        Print(context, {"connect", "connected", true}, {{EndsText(*required, *provided), {}}});
    const auto provider = LookUpProcess((*client)->catalogue(), provided->process);
    return provider ? printed : WarnOfUnknown(context, provider.error(), ends);
  }
  const auto made = SendConnect(context, *required, *provided, ends.when_connected());
  if (!made) return made.error();
  const Catalogue catalogue = (*client)->catalogue();
  const auto provider = LookUpProcess(catalogue, provided->process);
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
    context.out() << EndsText(made->required, made->provided) << "  " << state
                  << (is_said ? "" : ": " + Plain(made->reason)) << '\n';
  }
  if (is_unknown) return WarnOfUnknown(context, provider.error(), ends);
  return made->state == tendon::ConnectionState::kActive ? program::kOk : program::kRefused;
}

Result<void> SendDisconnect(Context& context, const InterfaceName& required) {
  return context.Ask<void>(
      [&](tendon::GcmClient& asked, auto handler) { asked.Disconnect(required, handler); });
}

/// Ends all connections whose required interface matches a glob.
Result<ExitCode> DisconnectAll(Context& context, const ConnectArguments& ends) {
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalogue catalogue = (*client)->catalogue();
  std::vector<tendon::ConnectionDescription> found;
  std::string question;
  for (const auto& one : catalogue.connections()) {
    if (!tendon::MatchesGlob(ends.required, ToString(one.required))) continue;
    found.push_back(one);
    question += " " + ToString(one.required);
  }
  if (found.empty()) {
    return Error{ErrorCode::kNotFound,
                 "no interface that matches '" + ends.required +
                     "' is connected; to list all connections: gcm ls -R -l --type req"};
  }
  question = "disconnect " + std::to_string(found.size()) + " interfaces:" + question;
  const bool asks = found.size() > 1 && !ends.yes && !ends.dry_run;
  if (asks && !Confirm(context, question)) return Declined();
  std::vector<Outcome> outcomes;
  for (const auto& one : found) {
    const auto plan = PlanDisconnect(catalogue, one.required);
    Result<void> result = plan ? Result<void>() : plan.error();
    if (plan && !ends.dry_run) result = SendDisconnect(context, one.required);
    outcomes.push_back({EndsText(one.required, one.provided), std::move(result)});
  }
  return Print(context, {"disconnect", "disconnected", ends.dry_run}, outcomes);
}

Result<ExitCode> Disconnect(Context& context, const ConnectArguments& ends) {
  if (auto allowed = CheckRole(context); ends.dry_run && !allowed) return allowed.error();
  if (IsGlob(ends.required)) return DisconnectAll(context, ends);
  const auto client = context.Client();
  if (!client) return client.error();
  const auto required = LookUpConnected((*client)->catalogue(), ends.required);
  if (!required) return required.error();
  if (ends.dry_run) {
    const auto plan = PlanDisconnect((*client)->catalogue(), *required);
    if (!plan) return plan.error();
    return Print(context, {"disconnect", "disconnected", true},
                 {{EndsText(plan->required, plan->provided), {}}});
  }
  if (auto done = SendDisconnect(context, *required); !done) return done.error();
  if (context.settings().json) {
    context.PrintJson({{"required", ToString(*required)}});
  } else {
    context.out() << ToString(*required) << "  disconnected\n";
  }
  return program::kOk;
}

}  // namespace

std::vector<Verb> ConnectionVerbs() {
  return {
      {"connect",
       "connect a required interface to a provided interface",
       [](CLI::App& app) -> Verb::Run {
         auto ends = std::make_shared<ConnectArguments>();
         WithKind(app.add_option("required", ends->required, "process/component/interface"),
                  WordKind::kRequired)
             ->required();
         WithKind(app.add_option("provided", ends->provided, "process/component/interface"),
                  WordKind::kProvided)
             ->required();
         app.add_flag(
             "--replace", ends->replace,
             "if the required interface is already connected, replace that connection in one step");
         app.add_flag(
             "--match", ends->match,
             "both arguments are patterns: connect each free required interface to the compatible "
             "provided interface; if several are compatible, to the interface with the same name");
         AddDryRun(app, ends->dry_run);
         app.add_flag("--yes", ends->yes, "do not ask, even if --match makes several connections");
         return [ends](Context& context) { return Connect(context, *ends); };
       },
       {"gcm connect desk/teleoperation/Robot robot/arm/Control",
        "gcm connect --match 'desk/**' 'robot/**' --dry-run"}},
      {"disconnect", "end the connection of a required interface",
       [](CLI::App& app) -> Verb::Run {
         auto ends = std::make_shared<ConnectArguments>();
         WithKind(app.add_option("required", ends->required,
                                 "process/component/interface; or the number of the connection, "
                                 "such as 3 or process/3; or a pattern such as desk/*/Robot"),
                  WordKind::kRequired)
             ->required();
         AddDryRun(app, ends->dry_run);
         app.add_flag("--yes", ends->yes,
                      "do not ask, even if a pattern matches several connections");
         return [ends](Context& context) { return Disconnect(context, *ends); };
       }},
  };
}

}  // namespace console
