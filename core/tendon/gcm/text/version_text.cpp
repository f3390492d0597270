#include <tendon/gcm/text/version_text.h>

namespace tendon {

std::string VersionText(const message::ProgramVersion& version) {
  return "version " + version.release + ", protocol " + std::to_string(version.protocol);
}

VersionReport JudgeVersion(const Result<message::ProgramVersion>& told,
                           const message::ProgramVersion& own) {
  if (!told && told.error().code == ErrorCode::kDenied) {
    return {.text = "of an old version that does not report itself"};
  }
  if (!told) return {.text = "of an unknown version (" + told.error().message + ")"};
  const bool is_own = told->release == own.release && told->protocol == own.protocol;
  return {.text = VersionText(*told) + (is_own ? "" : ", which is not that of this program"),
          .is_own = is_own};
}

}  // namespace tendon
