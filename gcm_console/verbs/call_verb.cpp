#include <gcm_console/command_line/argument_words.h>
#include <gcm_console/command_line/input_lines.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/queries.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/gcm/lookup.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

struct CallWords {
  std::string path;
  std::vector<std::string> argument;
  bool dry_run = false;
};

/// Returns the argument as JSON; empty if none is given. Mistakes in the command itself are
/// reported by the caller.
Result<std::string> ArgumentFor(Context& context, const CallWords& words) {
  if (words.argument.empty()) return std::string();
  if (words.argument == std::vector<std::string>{"-"}) {
    if (!context.streams().has_input) return NoInput("call " + words.path);
    return AllOf(std::cin);
  }
  const auto client = context.Client();
  if (!client) return client.error();
  const auto path = tendon::ParsePath(words.path);
  if (!path) return path.error();
  const auto command = LookUpCommand((*client)->catalogue(), *path);
  if (!command || !TakesArgument(command->signature)) return words.argument.front();
  const auto schema = AskSchema(context, path->process, command->signature.in);
  if (!schema && schema.error().code == ErrorCode::kNotFound) return words.argument.front();
  if (!schema) return schema.error();
  return ArgumentOf(*schema, words.path, words.argument);
}

/// Checks everything that can be checked before the call is sent to the process.
Result<void> CheckCall(Context& context, const std::string& text, const std::string& argument) {
  if (auto allowed = CheckRole(context); !allowed) return allowed;
  const auto path = tendon::ParsePath(text);
  if (!path) return path.error();
  const auto client = context.Client();
  if (!client) return client.error();
  const tendon::Catalogue catalogue = (*client)->catalogue();
  const auto command = LookUpCommand(catalogue, *path);
  if (!command) return command.error();
  const auto present = RequirePresent(catalogue.FindProcess(path->process)->process);
  if (!present) return present;
  const bool is_given = !argument.empty() && argument != "null";
  if (!TakesArgument(command->signature)) {
    if (!is_given) return {};
    return tendon::Error{tendon::ErrorCode::kInvalid,
                         text + " takes no argument: leave out the argument"};
  }
  const auto schema = AskSchema(context, path->process, command->signature.in);
  if (!schema) return schema.error();
  const auto value = tendon::FromJson(*schema, argument);
  if (value) return {};
  return tendon::Error{tendon::ErrorCode::kInvalid, text + ": " + value.error().message};
}

Result<ExitCode> PrintDryRun(Context& context, const std::string& path,
                             const std::string& argument) {
  if (const auto checked = CheckCall(context, path, argument); !checked) return checked.error();
  if (context.settings().json) {
    context.PrintJson({{"path", path}, {"value", nullptr}, {"dry_run", true}});
  } else {
    context.out() << Plain(path) << "\twould be called\n";
  }
  return program::kOk;
}

Result<ExitCode> Call(Context& context, const CallWords& words) {
  const auto argument = ArgumentFor(context, words);
  if (!argument) return argument.error();
  if (words.dry_run) return PrintDryRun(context, words.path, *argument);
  const auto result = context.Ask<std::string>([&](tendon::GcmClient& client, auto handler) {
    client.Call(words.path, *argument, handler);
  });
  if (!result) return result.error();
  if (context.settings().json) {
    const auto value = tendon::JsonOrText(result->empty() ? "null" : *result);
    context.PrintJson({{"path", words.path}, {"value", value}, {"dry_run", false}});
  } else if (!result->empty()) {
    context.out() << *result << '\n';
  }
  return program::kOk;
}

}  // namespace

std::vector<Verb> ActVerbs() {
  return {{"call",
           "execute a command",
           [](CLI::App& app) -> Verb::Run {
             auto words = std::make_shared<CallWords>();
             WithKind(app.add_option("path", words->path, "process/component/interface.command"),
                      WordKind::kCommand)
                 ->required();
             WithKind(app.add_option("argument", words->argument,
                                     "the argument, if the command has one: JSON, or one word for "
                                     "each field of a structure, in the order of the fields or as "
                                     "name=value; with -, JSON is read from stdin"),
                      WordKind::kArgument);
             app.add_flag("--dry-run", words->dry_run,
                          "only check whether the command can be called");
             return [words](Context& context) { return Call(context, *words); };
           },
           {"gcm call robot/arm/Control.Stop",
            "gcm call robot/arm/Control.MoveTo duration=2 'position=[0.1, 0, 0, -1, 0, 1, 0]'",
            "gcm call robot/arm/Control.MoveTo - < goal.json"}}};
}

}  // namespace console
