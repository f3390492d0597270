#pragma once

#include <tendon/base/name.h>

#include <string>
#include <string_view>

namespace tendon {

/// `process/component/interface.member(.field or [i])*`, the way every tool names a thing, for
/// example `robot/arm/state.Joints.position[0]`. Later parts may be empty: `robot/arm` is a path.
struct Path {
  std::string process;
  std::string component;
  std::string interface;
  std::string member;
  std::string field;  ///< what follows the member, with its first '.' or '[': ".position[0]"

  bool operator==(const Path&) const = default;
  [[nodiscard]] InterfaceName interface_name() const { return {process, component, interface}; }
};

/// Reads a path; the error names the part that is wrong.
Result<Path> ParsePath(std::string_view text);

[[nodiscard]] std::string ToString(const Path& path);

/// Whether `text` fits the glob `pattern`: `*` stands for any letters but '/' and '.', `**` for any
/// letters at all. For patterns that people type: cost
/// grows with the number of stars.
[[nodiscard]] bool MatchesGlob(std::string_view pattern, std::string_view text);

}  // namespace tendon
