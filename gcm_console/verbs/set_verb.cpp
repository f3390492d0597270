#include <gcm_console/output/table.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/configured_component.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/gcm/lifecycle/lifecycle_plan.h>
#include <tendon/gcm/lifecycle/parameters.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/process/lifecycle/configuration_base.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

using tendon::ChangedParameter;
using tendon::LifecycleVerb;
using tendon::Parameter;
using tendon::message::LifecycleOrder;
using Json = nlohmann::ordered_json;

struct SetWords {
  std::string component;
  std::string parameter;
  std::string value;
  bool is_to_be_set = false;
  bool dry_run = false;
};

Result<ExitCode> PrintParameters(const Context& context, const SetWords& words,
                                 const std::string& path, const ConfiguredComponent& component) {
  const auto parameters =
      words.parameter.empty()
          ? ParametersOf(component.description, component.configuration)
          : ParametersAt(component.description, component.configuration, words.parameter);
  if (!parameters) return Error{parameters.error().code, path + ": " + parameters.error().message};
  if (context.settings().json) {
    auto list = Json::array();
    for (const Parameter& one : *parameters) {
      list.push_back({{"parameter", one.name},
                      {"value", tendon::JsonOrText(one.value)},
                      {"type", one.type},
                      {"unit", one.unit},
                      {"values", one.values},
                      {"help", one.help}});
    }
    context.PrintJson({{"path", path}, {"parameters", std::move(list)}});
    return program::kOk;
  }
  Table table({"PARAMETER", "VALUE", "TYPE", "UNIT", "VALUES", "HELP"});
  for (const Parameter& one : *parameters) {
    table.Add({one.name, one.value, one.type, one.unit, one.values, one.help});
  }
  context.Print(table);
  return program::kOk;
}

void PrintChange(const Context& context, const SetWords& words, const std::string& path,
                 const ChangedParameter& changed) {
  if (context.settings().json) {
    context.PrintJson({{"path", path},
                       {"parameter", words.parameter},
                       {"former", tendon::JsonOrText(changed.former)},
                       {"value", tendon::JsonOrText(changed.value)},
                       {"dry_run", words.dry_run}});
    return;
  }
  context.out() << Plain(path + " " + words.parameter) << '\t';
  if (changed.former == changed.value) {
    context.out() << "is " << Plain(changed.value) << " already\n";
    return;
  }
  context.out() << (words.dry_run ? "would be " : "") << "set from " << Plain(changed.former)
                << " to " << Plain(changed.value) << '\n';
}

Result<void> Configure(Context& context, const LifecycleOrder& order, const SetWords& words) {
  const auto client = context.Client();
  if (!client) return client.error();
  if (auto checked = CheckLifecycleOrder((*client)->catalogue(), order); !checked) {
    const Error& why = checked.error();
    const bool is_stop_next = why.message.find("stop it first") != std::string::npos;
    return Error{why.code, why.message + (is_stop_next ? ": gcm stop " + words.component : "")};
  }
  if (words.dry_run) return CheckRole(context);
  return context.Ask<void>(
      [&](tendon::GcmClient& asked, auto handler) { asked.ExecuteLifecycleOrder(order, handler); },
      tendon::GcmClient::kLifecycleOrderTimeouts);
}

Result<ExitCode> Set(Context& context, const SetWords& words) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto found = LookUpOneComponent((*client)->catalogue(), words.component);
  if (!found) return found.error();
  const std::string path = ToString(*found);
  const auto component = FindConfigured(**client, context.settings().timeout, *found);
  if (!component) return component.error();
  if (!words.is_to_be_set) return PrintParameters(context, words, path, *component);
  const auto changed = ChangeParameter(component->description, component->configuration,
                                       words.parameter, words.value);
  if (!changed) return Error{changed.error().code, path + ": " + changed.error().message};
  if (changed->former != changed->value) {
    const LifecycleOrder order{.verb = LifecycleVerb::kConfigure,
                               .process = found->process,
                               .instance = component->instance,
                               .component = found->component,
                               .configuration = changed->configuration,
                               .based_on = tendon::BaseOf(component->configuration)};
    if (auto done = Configure(context, order, words); !done) return done.error();
  }
  PrintChange(context, words, path, *changed);
  return program::kOk;
}

}  // namespace

std::vector<Verb> SetVerbs() {
  return {{"set",
           "change one parameter of a component that does not run, or print its parameters",
           [](CLI::App& app) -> Verb::Run {
             auto words = std::make_shared<SetWords>();
             WithKind(app.add_option("component", words->component, "process/component"),
                      WordKind::kComponent)
                 ->required();
             WithKind(app.add_option("parameter", words->parameter,
                                     "for example gain, gain.x or gain[2]; if no parameter is "
                                     "given, all parameters are printed"),
                      WordKind::kParameter);
             const auto* value = WithKind(
                 app.add_option(
                     "value", words->value,
                     "the new value as JSON; if no value is given, the current value is printed"),
                 WordKind::kSetting);
             AddDryRun(app, words->dry_run);
             return [words, value](Context& context) {
               words->is_to_be_set = value->count() > 0;
               return Set(context, *words);
             };
           },
           {"gcm set robot/arm", "gcm set robot/arm noise 0.001",
            "gcm set robot/arm home[1] -0.5 --dry-run"}}};
}

}  // namespace console
