#pragma once

#include <tendon/base/backoff.h>
#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <string>
#include <vector>

namespace tendon::server {

/// The connections of processes that are gone. When a process returns, and both ends exist, its
/// connections are restored. Each is kept until it is made or finally refused. Not thread-safe.
class ConnectionRestorer {
 public:
  /// Keeps the present connections of the process, in addition to those that were not restored yet.
  void Keep(const Catalogue& catalogue, const std::string& process);
  void Drop(const std::string& process);

  /// The connections to order now. A connection is not returned again before Settle() was called
  /// for it. Silently drops a connection if one end returned with another class, or if the required
  /// interface was connected meanwhile.
  std::vector<message::Wire> TakeDue(const Catalogue& catalogue, SteadyTime now);

  enum class Verdict { kDone, kTryAgain, kStillTrying, kGivenUp };
  /// Reports the outcome of an order. A temporary failure is retried after a growing pause; the
  /// verdict is kTryAgain the first time, then kStillTrying.
  Verdict Settle(const message::Wire& wire, const Result<void>& outcome, SteadyTime now);

  /// True if a pause is over, so that TakeDue() may return connections without a change of the
  /// catalogue.
  [[nodiscard]] bool IsPauseOver(SteadyTime now) const;

 private:
  enum class Readiness { kWaiting, kDue, kPointless };
  struct Kept {
    message::Wire wire;
    std::string required_class;
    std::string provided_class;  ///< empty: not known
    bool is_ordered = false;
    Backoff backoff{std::chrono::milliseconds(200), std::chrono::milliseconds(5000)};
    SteadyTime not_before{};
  };

  static Readiness Judge(const Kept& kept, const Catalogue& catalogue);

  std::vector<Kept> kept_;
};

}  // namespace tendon::server
