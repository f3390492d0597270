#pragma once

#include <tendon/base/result.h>
#include <tendon/process/version_messages.h>

#include <string>

namespace tendon {

/// "version 0.4.0, protocol 10".
[[nodiscard]] std::string VersionText(const message::ProgramVersion& version);

/// A text about the version that a program reported, or about its absence, and whether it equals
/// `own`.
struct VersionReport {
  std::string text;  ///< "version 0.3.0, protocol 10, which is not that of this program"
  bool is_own = false;
};
[[nodiscard]] VersionReport JudgeVersion(const Result<message::ProgramVersion>& told,
                                         const message::ProgramVersion& own);

}  // namespace tendon
