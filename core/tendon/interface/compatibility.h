#pragma once

#include <tendon/interface/interface_description.h>
#include <tendon/payload/schema.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// The reason why one member of a required interface cannot be bound.
struct Mismatch {
  enum class Kind { kMissing, kOtherKind, kOtherType };

  Kind kind = Kind::kMissing;
  std::string member;
  std::string text;  ///< for people: "missing write command MoveTo"
};

/// The result of a comparison of a required and a provided interface. LCM, `gcm` and `gcm-gui` all
/// use this result.
struct Compatibility {
  int needed = 0;   ///< number of functions and handlers that are not optional
  int matched = 0;  ///< number of these that the provided interface offers
  std::vector<Mismatch> mismatches;

  [[nodiscard]] bool fits() const { return mismatches.empty(); }
  /// Returns all mismatches in one line, separated by "; ".
  [[nodiscard]] std::string Text() const;
};

/// Finds the schema of a type; empty if the type is unknown.
using SchemaLookup = std::function<std::optional<Schema>(Fingerprint)>;

/// Compares descriptions only. Every function needs a command, and every handler an event, of the
/// same name and signature. An optional member may be missing, but must not have a different
/// signature. The text names the first difference between two types if `find` knows both types.
[[nodiscard]] Compatibility Compare(const RequiredDescription& required,
                                    const ProvidedDescription& provided,
                                    const SchemaLookup& find = FindSchema);

/// Returns the error text of a refused connection: "teleoperation/Robot does not fit arm/Control:
/// ...".
[[nodiscard]] std::string Refusal(const std::string& required, const std::string& provided,
                                  const Compatibility& compatibility);

}  // namespace tendon
