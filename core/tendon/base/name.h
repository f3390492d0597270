#pragma once

#include <tendon/base/result.h>
#include <tendon/base/source_place.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace tendon {

/// Names of processes, components, interfaces and members: 1 to 64 letters, digits, '_' and '-'.
/// The error reads "component name 'a b' has ' ' at 2; allowed: letters digits _ - (max 64)";
/// `what` is the word before "name".
Result<void> CheckName(std::string_view what, std::string_view name);

/// The same for the author of a component: throws ConfigurationError.
void RequireName(std::string_view what, std::string_view name);

/// A name that must be given once, and where it was: made from text in a call, it knows the
/// caller's line.
struct PlacedName {
  PlacedName(const char* name, SourcePlace given_at = SourcePlace::current())
      : text(name), place(given_at) {}
  PlacedName(std::string name, SourcePlace given_at = SourcePlace::current())
      : text(std::move(name)), place(given_at) {}

  std::string text;
  SourcePlace place;
};

/// The candidate most like `name`, or empty when none is near: an edit distance of a third of its
/// length or 1, of 3 at most, and no more than half of either name; else the only one that begins
/// with `name`, of two letters at least. Case makes no difference.
[[nodiscard]] std::string Nearest(std::string_view name, std::span<const std::string> candidates);

/// "; did you mean 'arm'?" or, when nothing is near, the empty string.
[[nodiscard]] std::string DidYouMean(std::string_view name,
                                     std::span<const std::string> candidates);

/// Names one end of a connection. `process` is empty when this process is meant.
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

/// "robot/arm/Control", or "arm/Control" without a process.
[[nodiscard]] std::string ToString(const InterfaceName& name);

/// Reads "process/component/interface".
Result<InterfaceName> ParseInterfaceName(std::string_view text);

}  // namespace tendon
