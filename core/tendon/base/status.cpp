#include <tendon/base/status.h>

#include <array>

namespace tendon {

std::string_view ToString(Status status) noexcept {
  static constexpr std::array<std::string_view, Status::kFailed + 1> kWords = {
      "done",      "queued",      "not connected",   "not active",     "queue full",
      "no sample", "timeout",     "outcome unknown", "would deadlock", "denied",
      "disabled",  "unsupported", "invalid",         "failed"};
  return status.code() < kWords.size() ? kWords[status.code()] : "unknown status";
}

}  // namespace tendon
