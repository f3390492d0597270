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

/// Keeps the connections of processes that are gone. When a process has returned and both
/// interfaces exist again, its connections are due to be restored. Each connection is kept until it
/// is made or finally refused. Not thread-safe.
class ConnectionRestorer {
 public:
  /// Adds the present connections of the process to the kept ones.
  void Keep(const Catalogue& catalogue, const std::string& process);
  void Drop(const std::string& process);

  /// Returns the connections that can be made now. A connection is not returned again before
  /// Settle() was called for it. If a component has returned with another class, or the required
  /// interface was connected meanwhile, its connection is dropped silently.
  std::vector<message::Wire> TakeDue(const Catalogue& catalogue, SteadyTime now);

  enum class Verdict { kDone, kTryAgain, kStillTrying, kGivenUp };
  /// Called with the outcome of an attempt to make a connection. After a temporary failure, the
  /// connection is due again after a pause, which grows with each failure. The verdict is then
  /// kTryAgain for the first failure, and kStillTrying for further ones.
  Verdict Settle(const message::Wire& wire, const Result<void>& outcome, SteadyTime now);

  /// Returns true if the pause of a connection is over. TakeDue() may then return connections
  /// although the catalogue has not changed.
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
