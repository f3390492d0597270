#pragma once

#include <tendon/base/result.h>
#include <tendon/base/source_location.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tendon {

/// Checks the name of a process, component, interface or member: 1 to 64 letters, digits, '_' and
/// '-'. The error reads "component name 'a b' has ' ' at 2; allowed: letters digits _ - (max 64)";
/// `what` is the word before "name".
Result<void> CheckName(std::string_view what, std::string_view name);

/// Like CheckName(), but throws ConfigurationError. For names that the author of a component has
/// given.
void RequireName(std::string_view what, std::string_view name);

/// A name that may be given only once, with the source line that gave it. The implicit conversion
/// from text records the caller's line.
struct LocatedName {
  LocatedName(const char* name, SourceLocation given_at = SourceLocation::current())
      : text(name), location(given_at) {}
  LocatedName(std::string name, SourceLocation given_at = SourceLocation::current())
      : text(std::move(name)), location(given_at) {}

  std::string text;
  SourceLocation location;
};

/// Returns the candidate that is most similar to `name`; empty if no candidate is similar. Ignores
/// case. A candidate is similar if its edit distance from `name` is at most 3, at most a third of
/// the length of `name` (but 1 is always allowed), and at most half of the length of the shorter of
/// the two. If no candidate is similar, but exactly one begins with `name`, and `name` has at least
/// two letters, returns this candidate.
[[nodiscard]] std::string Nearest(std::string_view name, std::span<const std::string> candidates);

/// Returns "; did you mean 'arm'?", or an empty text if no candidate is similar.
[[nodiscard]] std::string DidYouMean(std::string_view name,
                                     std::span<const std::string> candidates);

/// Names one end of a connection. An empty `process` means this process.
struct InterfaceName {
  std::string process;
  std::string component;
  std::string interface;

  InterfaceName() = default;
  InterfaceName(std::string component_name, std::string interface_name)
      : component(std::move(component_name)), interface(std::move(interface_name)) {}
  InterfaceName(std::string process_name, std::string component_name, std::string interface_name)
      : process(std::move(process_name)),
        component(std::move(component_name)),
        interface(std::move(interface_name)) {}

  auto operator<=>(const InterfaceName&) const = default;
};

/// Returns "robot/arm/Control", or "arm/Control" if `process` is empty.
[[nodiscard]] std::string ToString(const InterfaceName& name);

/// Reads "process/component/interface".
Result<InterfaceName> ParseInterfaceName(std::string_view text);

}  // namespace tendon
