#pragma once

#include <tendon/interface/compatibility.h>

#include <string>
#include <vector>

namespace tendon::gui {

/// One member of a required interface beside the one of a provided interface that fills it, or
/// should.
struct SignatureRow {
  enum class Verdict {
    kSame,
    kMissing,   ///< needed, and not offered
    kChanged,   ///< offered with another kind or type
    kWithout,   ///< optional, and not offered
    kUnneeded,  ///< offered, and not needed
  };

  Verdict verdict = Verdict::kSame;
  bool is_event = false;
  const MemberDescription* needed = nullptr;   ///< null where it is not needed
  const MemberDescription* offered = nullptr;  ///< null where it is not offered
  std::string remark;                          ///< what is wrong, in words

  [[nodiscard]] bool is_bad() const {
    return verdict == Verdict::kMissing || verdict == Verdict::kChanged;
  }
};

/// What is needed in its order, commands before events; then what is offered besides. The rows
/// point into both descriptions. The verdicts are those of Compare().
[[nodiscard]] std::vector<SignatureRow> SignatureDiff(const RequiredDescription& required,
                                                      const ProvidedDescription& provided);

}  // namespace tendon::gui
