#pragma once

#include <tendon/interface/description.h>
#include <tendon/payload/schema.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// What keeps one member of a required interface from binding.
struct Mismatch {
  enum class Kind { kMissing, kOtherKind, kOtherType };

  Kind kind = Kind::kMissing;
  std::string member;
  std::string text;  ///< "missing write command MoveTo", one clause for a person
};

/// Whether a required and a provided interface fit. The same answer in an LCM, `gcm` and `gcm-gui`.
struct Compatibility {
  int needed = 0;   ///< functions and handlers that are not optional
  int matched = 0;  ///< how many of them the provided interface fills
  std::vector<Mismatch> mismatches;

  [[nodiscard]] bool fits() const { return mismatches.empty(); }
  /// All mismatches in one line, "; " between them.
  [[nodiscard]] std::string Text() const;
};

/// What a type is, where that is known.
using SchemaLookup = std::function<std::optional<Schema>(Fingerprint)>;

/// Works on descriptions alone. Every function needs a command, every handler an event, of the same
/// name and signature; an optional one may be missing but may not differ. Linear in the members.
/// The words name the first difference of two types that `find` knows.
[[nodiscard]] Compatibility Compare(const RequiredDescription& required,
                                    const ProvidedDescription& provided,
                                    const SchemaLookup& find = FindSchema);

/// The sentence of a refused connection: "teleoperation/Robot does not fit arm/Control: ...".
[[nodiscard]] std::string Refusal(const std::string& required, const std::string& provided,
                                  const Compatibility& compatibility);

}  // namespace tendon
