#pragma once

#include <gcm_console/context.h>
#include <tendon/gcm/catalogue.h>

#include <string>
#include <string_view>
#include <vector>

namespace console {

/// One thing of a system, as a row of a mixed list.
struct SystemItem {
  std::string path;
  std::string_view kind;  ///< one of kSystemItemKinds
  std::string type;       ///< class of a component, types of a member
  std::string state;      ///< of a process or component; "connected" of an interface
  std::string detail;     ///< its connections, or its problem
  std::string host;       ///< the host of its process

  bool operator==(const SystemItem&) const = default;
};

/// A kind of thing, and its name for `--type`.
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

/// All things, parents before their children; only those below `path` unless it is empty.
std::vector<SystemItem> ItemsIn(const tendon::Catalogue& catalogue, const std::string& path = "");

/// Prints a table, or one JSON document.
void PrintItems(Context& context, const std::vector<SystemItem>& items);

/// The depth of a path: 1 for a process, 4 for a member.
[[nodiscard]] int DepthOf(const std::string& path);

/// The peer of a required interface: "-> robot/arm/Control", "not connected".
[[nodiscard]] std::string ProviderOf(const tendon::Catalogue& catalogue,
                                     const tendon::InterfaceName& required);
/// The clients of a provided interface: "<- desk/supervisor/Robot and 2 more".
[[nodiscard]] std::string UsersOf(const tendon::Catalogue& catalogue,
                                  const tendon::InterfaceName& provided);

}  // namespace console
