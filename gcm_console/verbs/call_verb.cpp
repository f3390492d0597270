#include <gcm_console/verb.h>
#include <tendon/payload/json/strict_json.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

struct Arguments {
  std::string path;
  std::string argument;
};

tendon::Result<program::ExitCode> Call(Context& context, const Arguments& arguments) {
  std::string argument = arguments.argument;
  if (argument == "-" && !context.streams().has_input) return NoInput("call " + arguments.path);
  if (argument == "-") argument = {std::istreambuf_iterator<char>(std::cin), {}};
  const auto answer = context.Ask<std::string>([&](tendon::GcmClient& client, auto handler) {
    client.Call(arguments.path, argument, handler);
  });
  if (!answer) return answer.error();
  if (context.settings().json) {
    const auto value = tendon::JsonOrText(answer->empty() ? "null" : *answer);
    context.PrintJson({{"path", arguments.path}, {"value", value}});
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
             auto arguments = std::make_shared<Arguments>();
             Names(app.add_option("path", arguments->path, "process/component/interface.command"),
                   WordKind::kCommand)
                 ->required();
             app.add_option("argument", arguments->argument,
                            "JSON, where the command takes an argument; - reads it from stdin");
             return [arguments](Context& context) { return Call(context, *arguments); };
           },
           {"gcm call robot/arm/Control.Stop", "gcm call robot/arm/Control.MoveTo - < goal.json"}}};
}

}  // namespace console
