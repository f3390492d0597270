#pragma once

#include <tendon/base/name.h>

#include <string>
#include <string_view>

namespace tendon {

/// The name that every tool uses for a part of the system:
/// `process/component/interface.member(.field or [i])*`, for example
/// `robot/arm/state.Joints.position[0]`. The last parts may be omitted: `robot/arm` is a path, too.
struct Path {
  std::string process;
  std::string component;
  std::string interface;
  std::string member;
  std::string field;  ///< the text after the member, including its '.' or '[': ".position[0]"

  bool operator==(const Path&) const = default;
  [[nodiscard]] InterfaceName interface_name() const { return {process, component, interface}; }
};

/// Reads a path; the error names the invalid part.
Result<Path> ParsePath(std::string_view text);

[[nodiscard]] std::string ToString(const Path& path);

/// True if `text` fits the glob `pattern`: `*` matches any characters except '/' and '.', and `**`
/// matches any characters. Use it only for short patterns that people type, because the cost grows
/// with the number of stars.
[[nodiscard]] bool MatchesGlob(std::string_view pattern, std::string_view text);
/// True if `pattern` matches `path` or an object that contains it: "robot/*" for
/// "robot/arm/state.Joints".
[[nodiscard]] bool IsWithinGlob(std::string_view pattern, std::string_view path);

}  // namespace tendon
