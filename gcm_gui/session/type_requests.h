#pragma once

#include <tendon/base/backoff.h>
#include <tendon/base/clock.h>
#include <tendon/payload/fingerprint.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tendon::gui {

/// Schedules the requests for types, by fingerprint. A failed request is repeated after a pause.
/// With each failure the pause doubles, from kFirstPause up to kLongestPause. Not thread-safe.
class TypeRequests {
 public:
  static constexpr std::chrono::seconds kFirstPause{1};
  static constexpr std::chrono::seconds kLongestPause{30};

  /// Adds a type that must be requested from `process`. The last call for a type determines its
  /// process.
  void want(Fingerprint type, const std::string& process);
  /// Returns the types that must be requested now, each with its process. The caller must report
  /// each reply by onReply().
  [[nodiscard]] std::vector<std::pair<Fingerprint, std::string>> takeDue(SteadyTime now);
  /// Called with the result of a request.
  void onReply(Fingerprint type, const Result<Schema>& reply, SteadyTime now);
  /// Returns the last reply for a type; null if there is none.
  [[nodiscard]] const Result<Schema>* find(Fingerprint type) const;

 private:
  struct Request {
    std::string process;
    std::optional<Result<Schema>> reply;
    bool is_asking = false;
    SteadyTime due{};
    Backoff backoff{kFirstPause, kLongestPause};
  };

  std::map<Fingerprint, Request> wanted_;
};

}  // namespace tendon::gui
