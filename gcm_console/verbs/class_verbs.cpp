#include <gcm_console/output/catalogue_json.h>
#include <gcm_console/output/table.h>
#include <gcm_console/output/text.h>
#include <gcm_console/verbs/common_options.h>
#include <gcm_console/verbs/configured_component.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/queries.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lifecycle/class_check.h>
#include <tendon/gcm/lifecycle/lifecycle_plan.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system_file.h>
#include <tendon/gcm/text.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/schema.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

namespace console {
namespace {

using program::ExitCode;
using tendon::Catalogue;
using tendon::ClassDescription;
using tendon::Error;
using tendon::ErrorCode;
using tendon::LifecycleVerb;
using tendon::Result;
using tendon::message::Classes;
using tendon::message::LifecycleOrder;

struct ClassArguments {
  std::string process;
  std::string library;
  std::string class_name;
  std::string component;
  std::string json;
  std::string file;
  bool dry_run = false;
};

/// Returns the process that the user has named; otherwise the only process that is present.
Result<std::string> ProcessOf(const Catalogue& catalogue, const std::string& named) {
  if (!named.empty()) return named;
  std::vector<std::string> present;
  for (const auto& [name, entry] : catalogue.processes()) {
    if (IsPresent(entry.process)) present.push_back(name);
  }
  if (present.size() == 1) return present.front();
  if (present.empty()) {
    return Error{ErrorCode::kNotFound,
                 "no process has joined the GCM; to start a process: lcm --name NAME"};
  }
  return Error{ErrorCode::kInvalid,
               "there are several processes; give one of these: " + Joined(present, ", ")};
}

/// Returns the configuration from the command line or from a file; empty if neither is given.
Result<std::string> ConfigurationOf(const ClassArguments& arguments) {
  if (arguments.file.empty()) return arguments.json;
  auto text = tendon::ReadSystemText(arguments.file);
  if (!text) return text;
  if (text->size() > tendon::SystemFile::kMaxSize) {
    return Error{ErrorCode::kInvalid, arguments.file + " is over 16 MB: give a smaller file"};
  }
  if (text->empty()) {
    return Error{ErrorCode::kInvalid, arguments.file + ": expected a JSON object, found nothing"};
  }
  return text;
}

/// Returns the file from which the process has loaded the library of `order`; empty if the process
/// does not report it. If the order names no library, uses the library that contains the class.
std::optional<tendon::PluginDescription> AskForPlugin(Context& context,
                                                      const LifecycleOrder& order) {
  const auto known = AskClasses(context, order.process);
  if (!known) return std::nullopt;
  std::string library = order.library;
  if (library.empty()) {
    const auto* one = tendon::FindNamed(known->classes, order.class_name);
    if (one != nullptr) library = one->library;
  }
  const auto* loaded = tendon::FindNamed(known->loaded, library);
  return loaded == nullptr ? std::nullopt : std::optional(*loaded);
}

/// Warns if the file of the plug-in differs from the running code. The warning is printed even with
/// --quiet.
void WarnOfOld(const Context& context, const std::string& process,
               const tendon::PluginDescription& plugin) {
  const std::string old = tendon::OutdatedPluginText(process, plugin);
  if (old.empty()) return;
  context.out().flush();
  context.streams().err << "gcm: " << Plain(old) << '\n';
}

/// Checks as far as possible whether the order would succeed.
Result<void> Check(Context& context, tendon::GcmClient& client, const LifecycleOrder& order) {
  if (auto allowed = CheckRole(context); !allowed) return allowed;
  if (auto checked = CheckLifecycleOrder(client.catalogue(), order); !checked) return checked;
  if (order.verb == LifecycleVerb::kConfigure) {
    const auto component = FindConfigured(client, context.settings().timeout,
                                          {.process = order.process, .component = order.component});
    return component ? tendon::CheckConfiguration(component->description, order.configuration)
                     : component.error();
  }
  const auto known = AskClasses(context, order.process);
  if (!known) return known.error();
  return order.verb == LifecycleVerb::kLoad ? tendon::CheckPlugIn(*known, order.library)
                                            : tendon::CheckCreation(*known, order);
}

/// Executes the order, or prints what the order would do. `object` and `done` are words for the
/// message.
Result<ExitCode> Execute(Context& context, const LifecycleOrder& order, const std::string& object,
                         const std::string& done, bool is_dry) {
  const auto client = context.Client();
  if (!client) return client.error();
  const Result<void> outcome =
      is_dry ? Check(context, **client, order)
             : context.Ask<void>([&](tendon::GcmClient& asked,
                                     auto handler) { asked.ExecuteLifecycleOrder(order, handler); },
                                 tendon::GcmClient::kLifecycleOrderTimeouts);
  if (!outcome) return outcome.error();
  const bool has_plugin = order.verb != LifecycleVerb::kConfigure;
  const auto plugin = has_plugin ? AskForPlugin(context, order) : std::nullopt;
  if (context.settings().json) {
    nlohmann::ordered_json document = {
        {"verb", ToString(order.verb)}, {"path", object}, {"dry_run", is_dry}};
    if (plugin) document["plugin"] = ToJson(*plugin);
    context.PrintJson(std::move(document));
  } else {
    context.out() << Plain(object) << '\t' << (is_dry ? "would be " : "") << done << '\n';
  }
  if (!plugin) return program::kOk;
  const bool is_current = plugin->state == tendon::PluginState::kCurrent;
  if (is_current) context.err() << "gcm: " << Plain(tendon::PluginText(*plugin)) << '\n';
  WarnOfOld(context, order.process, *plugin);
  return program::kOk;
}

Result<ExitCode> Load(Context& context, const ClassArguments& arguments) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto process = ProcessOf((*client)->catalogue(), arguments.process);
  if (!process) return process.error();
  const LifecycleOrder order{
      .verb = LifecycleVerb::kLoad, .process = *process, .library = arguments.library};
  return Execute(context, order, *process + " " + arguments.library, "loaded", arguments.dry_run);
}

Result<ExitCode> Create(Context& context, const ClassArguments& arguments) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto path = tendon::ParsePath(arguments.component);
  const bool is_whole = arguments.component.find('/') != std::string::npos;
  if (is_whole && !path) return path.error();
  if (is_whole && (!path->interface.empty() || !arguments.process.empty())) {
    return Error{ErrorCode::kInvalid,
                 "'" + arguments.component +
                     "' does not name a component: expected process/component, or only the name of "
                     "the component together with --in process"};
  }
  const auto process =
      ProcessOf((*client)->catalogue(), is_whole ? path->process : arguments.process);
  if (!process) return process.error();
  const auto configuration = ConfigurationOf(arguments);
  if (!configuration) return configuration.error();
  if (arguments.class_name.empty()) {
    return Error{ErrorCode::kInvalid, "no class is given; to list the classes of '" + *process +
                                          "': gcm classes " + *process};
  }
  const LifecycleOrder order{.verb = LifecycleVerb::kCreate,
                             .process = *process,
                             .component = is_whole ? path->component : arguments.component,
                             .class_name = arguments.class_name,
                             .library = arguments.library,
                             .configuration = *configuration};
  return Execute(context, order, *process + "/" + order.component, "created", arguments.dry_run);
}

Result<ExitCode> Configure(Context& context, const ClassArguments& arguments) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto found = LookUpOneComponent((*client)->catalogue(), arguments.component);
  if (!found) return found.error();
  const auto configuration = ConfigurationOf(arguments);
  if (!configuration) return configuration.error();
  if (configuration->empty()) {
    return Error{ErrorCode::kInvalid,
                 "the configuration is missing: give --arg or --configure; for the default values: "
                 "--arg {}"};
  }
  const LifecycleOrder order{.verb = LifecycleVerb::kConfigure,
                             .process = found->process,
                             .component = found->component,
                             .configuration = *configuration};
  return Execute(context, order, ToString(*found), "configured", arguments.dry_run);
}

/// Returns the type of a class's configuration: "arm.Configuration", or "-" if it has none.
std::string ConfigurationType(const ClassDescription& one) {
  const auto schema = tendon::Schema::Parse(one.configuration);
  if (!schema) return "?";
  return schema->is_none() ? "-" : schema->TypeName();
}

void PrintJson(const Context& context, const std::string& process, const Classes& all) {
  using Json = nlohmann::ordered_json;
  auto classes = Json::array();
  for (const ClassDescription& one : all.classes) {
    const Json defaults = tendon::JsonOrText(one.defaults);  // need not be an object
    classes.push_back({{"class", one.name},
                       {"library", one.library},
                       {"configuration", one.configuration},
                       {"defaults", defaults.is_object() ? defaults : Json::object()}});
  }
  auto loaded = Json::array();
  for (const tendon::PluginDescription& one : all.loaded) loaded.push_back(ToJson(one));
  context.PrintJson({{"process", process},
                     {"classes", std::move(classes)},
                     {"plugins", all.plugins},
                     {"loaded", std::move(loaded)}});
}

void Print(const Context& context, const ClassDescription& one) {
  context.out() << Plain(one.library) << '/' << Plain(one.name) << '\n';
  std::string line;  // the text is escaped, because it cannot be trusted
  for (const char letter : one.configuration + "\n") {
    if (letter != '\n') {
      line += letter;
    } else if (!line.empty()) {
      context.out() << Plain(std::exchange(line, "")) << '\n';
    }
  }
  context.out() << "defaults: " << Plain(one.defaults) << '\n';
}

/// Removes all classes except the first one with that name.
Result<void> Choose(Classes& all, const std::string& class_name) {
  std::vector<std::string> names;
  for (const ClassDescription& one : all.classes) names.push_back(one.name);
  const auto chosen = std::ranges::find(all.classes, class_name, &ClassDescription::name);
  if (chosen == all.classes.end()) {
    return Error{ErrorCode::kNotFound, "the process has no loaded class '" + class_name + "'" +
                                           tendon::DidYouMean(class_name, names)};
  }
  all.classes = {ClassDescription(*chosen)};
  return {};
}

Result<ExitCode> List(Context& context, const ClassArguments& arguments) {
  const auto client = context.Client();
  if (!client) return client.error();
  const auto process = ProcessOf((*client)->catalogue(), arguments.process);
  if (!process) return process.error();
  auto all = AskClasses(context, *process);
  if (!all) return all.error();
  const bool is_one = !arguments.class_name.empty();
  if (is_one) {
    if (auto chosen = Choose(*all, arguments.class_name); !chosen) return chosen.error();
  }
  if (context.settings().json) {
    PrintJson(context, *process, *all);
    return program::kOk;
  }
  if (is_one) {
    Print(context, all->classes.front());
    const auto* loaded = tendon::FindNamed(all->loaded, all->classes.front().library);
    if (loaded != nullptr) WarnOfOld(context, *process, *loaded);
    return program::kOk;
  }
  Table table({"CLASS", "LIBRARY", "CONFIGURATION", "FILE"});
  for (const ClassDescription& one : all->classes) {
    const auto* loaded = tendon::FindNamed(all->loaded, one.library);
    table.Add({one.name, one.library, ConfigurationType(one),
               loaded == nullptr ? "" : tendon::PluginText(*loaded)});
  }
  context.Print(table);
  for (const auto& one : all->loaded) WarnOfOld(context, *process, one);
  std::string more;
  for (const std::string& plugin : all->plugins) {
    const auto is_loaded = [&](const ClassDescription& one) { return one.library == plugin; };
    if (std::ranges::none_of(all->classes, is_loaded)) more += " " + plugin;
  }
  if (!more.empty())
    context.err() << "gcm: plug-ins that can also be loaded:" << Plain(more) << '\n';
  return program::kOk;
}

void AddConfiguration(CLI::App& app, ClassArguments& arguments) {
  const auto check_given = [](const std::string& text) -> std::string {
    return text.empty() ? "expected a JSON object such as {}, got ''" : "";
  };
  auto* json =
      app.add_option("--arg", arguments.json, "configuration of the component, as a JSON object")
          ->check(check_given);
  WithKind(app.add_option("--configure", arguments.file,
                          "a file with the configuration of the component"),
           WordKind::kFile)
      ->excludes(json);
}

void AddProcess(CLI::App& app, ClassArguments& arguments) {
  WithKind(app.add_option("--in", arguments.process,
                          "the process; only needed if there are several processes"),
           WordKind::kProcess);
}

}  // namespace

std::vector<Verb> ClassVerbs() {
  return {
      {"load", "load a plug-in into a process",
       [](CLI::App& app) -> Verb::Run {
         auto arguments = std::make_shared<ClassArguments>();
         WithKind(
             app.add_option("library", arguments->library, "name of the plug-in, without path"),
             WordKind::kPlugIn)
             ->required();
         AddProcess(app, *arguments);
         AddDryRun(app, arguments->dry_run);
         return [arguments](Context& context) { return Load(context, *arguments); };
       }},
      {"classes", "list the classes of which a process can create components",
       [](CLI::App& app) -> Verb::Run {
         auto arguments = std::make_shared<ClassArguments>();
         WithKind(app.add_option("process", arguments->process,
                                 "the process; only needed if there are several processes"),
                  WordKind::kProcess);
         WithKind(app.add_option("class", arguments->class_name,
                                 "show the fields of the configuration of this class"),
                  WordKind::kClass);
         return [arguments](Context& context) { return List(context, *arguments); };
       }},
      {"create", "create a component of a class",
       [](CLI::App& app) -> Verb::Run {
         auto arguments = std::make_shared<ClassArguments>();
         WithKind(app.add_option("class", arguments->class_name,
                                 "the class; to list all classes: gcm classes"),
                  WordKind::kClass)
             ->required();
         app.add_option("name", arguments->component, "process/component, or only the component")
             ->required();
         AddProcess(app, *arguments);
         WithKind(app.add_option("--library", arguments->library,
                                 "the plug-in with the class; this plug-in is loaded if necessary"),
                  WordKind::kPlugIn);
         AddConfiguration(app, *arguments);
         AddDryRun(app, arguments->dry_run);
         return [arguments](Context& context) { return Create(context, *arguments); };
       }},
      {"configure",
       "replace the configuration of a component that does not run: the component is created again",
       [](CLI::App& app) -> Verb::Run {
         auto arguments = std::make_shared<ClassArguments>();
         WithKind(app.add_option("component", arguments->component, "process/component"),
                  WordKind::kComponent)
             ->required();
         AddConfiguration(app, *arguments);
         AddDryRun(app, arguments->dry_run);
         return [arguments](Context& context) { return Configure(context, *arguments); };
       }},
  };
}

}  // namespace console
