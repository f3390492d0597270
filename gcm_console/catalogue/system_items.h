#pragma once

#include <gcm_console/context.h>
#include <tendon/gcm/catalogue.h>

#include <string>
#include <string_view>
#include <vector>

namespace console {

/// One object of a system, as a row of a list of different objects.
struct SystemItem {
  std::string path;
  std::string_view kind;  ///< one of kSystemItemKinds
  std::string type;       ///< class of a component, or types of a member
  std::string state;   ///< state of a process or component; for an interface "connected" or empty
  std::string detail;  ///< connections of the object, or its problem
  std::string host;    ///< host of the process to which the object belongs

  bool operator==(const SystemItem&) const = default;
};

/// A kind of object, and its code for the option `--type`.
struct SystemItemKind {
  std::string_view name;
  std::string_view code;
};
inline constexpr SystemItemKind kSystemItemKinds[] = {{"process", "proc"},
                                                      {"component", "comp"},
                                                      {"provided interface", "prov"},
                                                      {"required interface", "req"},
                                                      {"command", "cmd"},
                                                      {"event", "event"},
                                                      {"function", "fn"},
                                                      {"event handler", "handler"},
                                                      {"column", "state"}};

/// Returns all objects, parents before their children. If `path` is not empty, returns only the
/// objects below it.
std::vector<SystemItem> ItemsIn(const tendon::Catalogue& catalogue, const std::string& path = "");

/// Prints the items as a table, or as one JSON document with --json.
void PrintItems(Context& context, const std::vector<SystemItem>& items);

/// Returns the number of names in a path: 1 for a process, 4 for a member.
[[nodiscard]] int DepthOf(const std::string& path);

/// Returns the peer of a required interface: "-> robot/arm/Control", "not connected".
[[nodiscard]] std::string ProviderOf(const tendon::Catalogue& catalogue,
                                     const tendon::InterfaceName& required);
/// Returns the clients of a provided interface: "<- desk/supervisor/Robot and 2 more".
[[nodiscard]] std::string UsersOf(const tendon::Catalogue& catalogue,
                                  const tendon::InterfaceName& provided);

}  // namespace console
