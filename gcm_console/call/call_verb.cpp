#include <gcm_console/call/argument_words.h>
#include <gcm_console/verb.h>
#include <tendon/gcm/lookup.h>
#include <tendon/payload/json/strict_json.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

struct CallWords {
  std::string path;
  std::vector<std::string> argument;
};

/// As JSON; empty where there is none. What is wrong with the command itself whoever calls it says.
Result<std::string> ArgumentFor(Context& context, const CallWords& words) {
  if (words.argument.empty()) return std::string();
  if (words.argument == std::vector<std::string>{"-"}) {
    if (!context.streams().has_input) return NoInput("call " + words.path);
    return std::string(std::istreambuf_iterator<char>(std::cin), {});
  }
  const auto client = context.Client();
  if (!client) return client.error();
  const auto path = tendon::ParsePath(words.path);
  if (!path) return path.error();
  const auto command = LookUpCommand((*client)->catalog(), *path);
  if (!command || !TakesArgument(command->signature)) return words.argument.front();
  const auto schema = context.Ask<tendon::Schema>([&](tendon::GcmClient& asked, auto handler) {
    asked.GetSchema(path->process, command->signature.in, std::move(handler));
  });
  if (!schema) return schema.error();
  return ArgumentOf(*schema, words.path, words.argument);
}

Result<ExitCode> Call(Context& context, const CallWords& words) {
  const auto argument = ArgumentFor(context, words);
  if (!argument) return argument.error();
  const auto answer = context.Ask<std::string>([&](tendon::GcmClient& client, auto handler) {
    client.Call(words.path, *argument, handler);
  });
  if (!answer) return answer.error();
  if (context.settings().json) {
    const auto value = tendon::JsonOrText(answer->empty() ? "null" : *answer);
    context.PrintJson({{"path", words.path}, {"value", value}});
  } else if (!answer->empty()) {
    context.out() << *answer << '\n';
  }
  return program::kOk;
}

}  // namespace

std::vector<Verb> ActVerbs() {
  return {{"call",
           "execute a command",
           [](CLI::App& app) -> Verb::Run {
             auto words = std::make_shared<CallWords>();
             Names(app.add_option("path", words->path, "process/component/interface.command"),
                   WordKind::kCommand)
                 ->required();
             Names(app.add_option("argument", words->argument,
                                  "where the command takes one: JSON, or the fields of a structure "
                                  "as words, in their order or as name=value; - reads JSON from "
                                  "stdin"),
                   WordKind::kArgument)
                 ->allow_extra_args(false);  // which would take a list apart
             return [words](Context& context) { return Call(context, *words); };
           },
           {"gcm call robot/arm/Control.Stop",
            "gcm call robot/arm/Control.MoveTo duration=2 'position=[0.1, 0, 0, -1, 0, 1, 0]'",
            "gcm call robot/arm/Control.MoveTo - < goal.json"}}};
}

}  // namespace console
