#pragma once

#include <tendon/interface/compatibility.h>

#include <string>
#include <vector>

namespace tendon::gui {

/// A row of the comparison of two interfaces: a member of the required interface, and the member of
/// the provided interface with the same name. One of the two may be missing.
struct SignatureRow {
  enum class Verdict {
    kSame,
    kMissing,   ///< needed, but not offered
    kChanged,   ///< offered with another kind or type
    kWithout,   ///< optional, and not offered
    kUnneeded,  ///< offered, but not needed
  };

  Verdict verdict = Verdict::kSame;
  bool is_event = false;
  const MemberDescription* needed = nullptr;   ///< null if not needed
  const MemberDescription* offered = nullptr;  ///< null if not offered
  std::string remark;                          ///< the mistake in words

  [[nodiscard]] bool is_bad() const {
    return verdict == Verdict::kMissing || verdict == Verdict::kChanged;
  }
};

/// Compares two interfaces. The rows list first the needed members in their order, commands before
/// events, then the members that are not needed. The rows contain pointers into both descriptions.
/// The verdicts are the same as in Compare().
[[nodiscard]] std::vector<SignatureRow> SignatureDiff(const RequiredDescription& required,
                                                      const ProvidedDescription& provided);

}  // namespace tendon::gui
