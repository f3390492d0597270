#pragma once

#include <tendon/base/name.h>

#include <string>
#include <string_view>

namespace tendon {

/// The name that every tool uses for a part of the system:
/// `process/component/interface.member(.field or [i])*`, for example
/// `robot/arm/state.Joints.position[0]`. Parts may be left out from the end: `robot/arm` is a path.
struct Path {
  std::string process;
  std::string component;
  std::string interface;
  std::string member;
  std::string field;  ///< the rest after the member, with its first '.' or '[': ".position[0]"

  bool operator==(const Path&) const = default;
  [[nodiscard]] InterfaceName interface_name() const { return {process, component, interface}; }
};

/// Reads a path; the error names the invalid part.
Result<Path> ParsePath(std::string_view text);

[[nodiscard]] std::string ToString(const Path& path);

/// True if `text` fits the glob `pattern`: `*` stands for any letters except '/' and '.', `**` for
/// any letters at all. Meant for short patterns that people type: the cost grows with the number of
/// stars.
[[nodiscard]] bool MatchesGlob(std::string_view pattern, std::string_view text);

}  // namespace tendon
