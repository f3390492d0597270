#pragma once

#include <tendon/base/clock.h>
#include <tendon/payload/fingerprint.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon::gui {

/// Types of values that processes are asked for, by fingerprint. One that was not told is asked for
/// again, after a pause that doubles from kFirstPause to kLongestPause. Not thread-safe.
class AskedTypes {
 public:
  static constexpr std::chrono::seconds kFirstPause{1};
  static constexpr std::chrono::seconds kLongestPause{30};

  /// From now on it is wanted; `process` is who has it, the last one that was named.
  void want(Fingerprint type, const std::string& process);
  /// The types that are to be asked for now, each with its process; none twice before hear().
  [[nodiscard]] std::vector<std::pair<Fingerprint, std::string>> takeDue(SteadyTime now);
  /// What came of the question.
  void hear(Fingerprint type, const Result<Schema>& answer, SteadyTime now);
  /// The last answer; null while there was none.
  [[nodiscard]] const Result<Schema>* find(Fingerprint type) const;

 private:
  struct Wanted {
    std::string process;
    std::optional<Result<Schema>> answer;
    bool is_asking = false;
    SteadyTime due{};
    std::chrono::nanoseconds pause = kFirstPause;
  };

  std::map<Fingerprint, Wanted> wanted_;
};

}  // namespace tendon::gui
