#pragma once

#include <gcm_console/context.h>
#include <tendon/gcm/catalog.h>

#include <string>
#include <string_view>
#include <vector>

namespace console {

/// One thing of a system, as lists of many kinds of things show it.
struct Thing {
  std::string path;
  std::string_view noun;  ///< one of kNouns
  std::string type;       ///< class of a component, types of a member
  std::string state;      ///< of a process or component, "connected" of an interface
  std::string detail;     ///< who is connected to it, what is wrong with it
  std::string host;       ///< where its process is

  bool operator==(const Thing&) const = default;
};

/// What a thing can be, and how `--type` calls it.
struct Noun {
  std::string_view name;
  std::string_view code;
};
inline constexpr Noun kNouns[] = {{"process", "proc"},
                                  {"component", "comp"},
                                  {"provided interface", "prov"},
                                  {"required interface", "req"},
                                  {"command", "cmd"},
                                  {"event", "event"},
                                  {"function", "fn"},
                                  {"event handler", "handler"},
                                  {"column", "state"}};

/// All things, each before those in it; those below `path` where it is not empty.
std::vector<Thing> ThingsIn(const tendon::Catalog& catalog, const std::string& path = "");

/// As a table, or as one JSON document.
void PrintThings(Context& context, const std::vector<Thing>& things);

/// How deep a path is: 1 of a process, 4 of a member.
[[nodiscard]] int DepthOf(const std::string& path);

/// What a required interface is connected to: "-> robot/arm/Control", "not connected".
[[nodiscard]] std::string ProviderOf(const tendon::Catalog& catalog,
                                     const tendon::InterfaceName& required);
/// Who is connected to a provided interface: "<- desk/supervisor/Robot and 2 more".
[[nodiscard]] std::string UsersOf(const tendon::Catalog& catalog,
                                  const tendon::InterfaceName& provided);

}  // namespace console
