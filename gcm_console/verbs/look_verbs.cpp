#include <gcm_console/catalogue/glob.h>
#include <gcm_console/catalogue/path_target.h>
#include <gcm_console/catalogue/system_items.h>
#include <gcm_console/output/table.h>
#include <gcm_console/verbs/path_details.h>
#include <gcm_console/verbs/queries.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/gcm/text.h>
#include <tendon/gcm/waiting.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

namespace console {
namespace {

using program::ExitCode;
using tendon::Catalogue;
using tendon::Result;
using tendon::message::SystemHealth;

struct ListOptions {
  std::string path;
  bool is_recursive = false;
  bool is_long = false;
  std::vector<std::string> types;  ///< codes of kSystemItemKinds
};

/// Adds processor and memory use to the processes that have no other detail.
void AddHealth(Context& context, const Catalogue& catalogue, std::vector<SystemItem>& items) {
  const auto lacks_detail = [&](const SystemItem& item) {
    return item.kind == "process" && item.detail.empty();
  };
  if (std::none_of(items.begin(), items.end(), lacks_detail)) return;
  const SystemHealth health = AskHealth(context);
  for (SystemItem& item : items) {
    if (!lacks_detail(item)) continue;
    const auto* of_process = FindHealth(health, catalogue.FindProcess(item.path)->process);
    item.detail =
        "cpu " + tendon::CpuText(of_process) + ", memory " + tendon::MemoryText(of_process);
  }
}

/// Returns the contents of a path or, for a glob, the matches. If `is_deep`, also returns
/// everything inside these objects.
Result<std::vector<SystemItem>> ListedItems(const Catalogue& catalogue,
                                            const ListOptions& options) {
  const bool is_deep = options.is_recursive || !options.types.empty();
  if (IsGlob(options.path)) {
    return is_deep ? MatchingItemsAndContents(catalogue, options.path)
                   : MatchingItems(catalogue, options.path);
  }
  const int deepest = DepthOf(options.path) + 1;
  auto items = ItemsIn(catalogue, options.path);
  std::erase_if(items,
                [&](const SystemItem& one) { return !is_deep && DepthOf(one.path) > deepest; });
  return items;
}

/// Prints objects by their full paths. If the user has given types, prints only objects of these
/// types.
Result<ExitCode> ListItems(Context& context, const Catalogue& catalogue,
                           const ListOptions& options) {
  auto found = ListedItems(catalogue, options);
  if (!found) return found.error();
  auto& items = *found;
  std::erase_if(items, [&](const SystemItem& item) {
    const auto kind =
        std::find_if(std::begin(kSystemItemKinds), std::end(kSystemItemKinds),
                     [&](const SystemItemKind& one) { return one.name == item.kind; });
    return !options.types.empty() &&
           std::find(options.types.begin(), options.types.end(), kind->code) == options.types.end();
  });
  if (options.is_long) AddHealth(context, catalogue, items);
  PrintItems(context, items);
  return program::kOk;
}

Result<ExitCode> List(Context& context, const std::string& path) {
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalogue catalogue = (*client)->catalogue();
  const auto target = path.empty() ? Result<PathTarget>(PathTarget{}) : FindTarget(catalogue, path);
  if (!target) return target.error();
  if (context.settings().json) {
    context.PrintJson(JsonOf(context, catalogue, *target));
  } else {
    context.Print(ListingOf(catalogue, *target));
  }
  return program::kOk;
}

void PrintTree(const Catalogue& catalogue, std::ostream& out) {
  for (const auto& [process_name, entry] : catalogue.processes()) {
    out << Plain(process_name) << "  " << ToString(entry.process.state) << '\n';
    for (const auto& [name, component] : entry.components) {
      out << "  " << Plain(name) << "  " << Plain(StateText(entry, component)) << '\n';
      for (const auto& one : component.provided) {
        const std::string users = UsersOf(catalogue, {process_name, name, one.name});
        out << "    " << Plain(one.name) << "  provided" << (users.empty() ? "" : "  ")
            << Plain(users) << '\n';
      }
      for (const auto& one : component.required) {
        out << "    " << Plain(one.name) << "  required  "
            << Plain(ProviderOf(catalogue, {process_name, name, one.name})) << '\n';
      }
    }
  }
}

Result<ExitCode> List(Context& context, const ListOptions& options) {
  ListOptions wanted = options;
  if (wanted.path.empty()) wanted.path = context.settings().at;
  const bool is_glob = IsGlob(wanted.path);
  if (!wanted.is_recursive && !wanted.is_long && wanted.types.empty() && !is_glob) {
    return List(context, wanted.path);
  }
  const auto client = context.Client();
  if (!client) return client.error();
  const Catalogue catalogue = (*client)->catalogue();
  const bool is_path = !wanted.path.empty() && !is_glob;
  const auto target =
      is_path ? FindTarget(catalogue, wanted.path) : Result<PathTarget>(PathTarget{});
  if (!target) return target.error();
  return ListItems(context, catalogue, wanted);
}

Result<ExitCode> Tree(Context& context) {
  if (context.settings().json) return List(context, "");
  const auto client = context.Client();
  if (!client) return client.error();
  PrintTree((*client)->catalogue(), context.out());
  return program::kOk;
}

Verb::Run PrepareList(CLI::App& app) {
  auto options = std::make_shared<ListOptions>();
  WithKind(app.add_option("path", options->path,
                          "process/component/interface.member, or the first parts of it; or a "
                          "pattern that matches several"),
           WordKind::kPath);
  app.add_flag("-R,--recursive", options->is_recursive, "also list all contents, as paths");
  app.add_flag("-l,--long", options->is_long, "list paths with type, state and connections");
  std::vector<std::string> codes;
  for (const SystemItemKind& kind : kSystemItemKinds) codes.emplace_back(kind.code);
  app.add_option("--type", options->types,
                 "list only objects of these types, at any depth; separate the types by commas")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(CLI::IsMember(codes));
  return [options](Context& context) { return List(context, *options); };
}

}  // namespace

std::vector<Verb> LookVerbs() {
  return {
      {"ls",
       "list processes, or the contents of one object",
       &PrepareList,
       {"gcm ls robot/arm", "gcm ls 'robot/*'", "gcm ls -R -l", "gcm ls robot --type cmd,event"}},
      {"tree", "show the whole catalogue", [](CLI::App&) -> Verb::Run { return &Tree; }},
  };
}

}  // namespace console
