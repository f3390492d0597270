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

/// Keeps the connections of processes that are absent. They are restored when the process has
/// returned and both interfaces exist again. Each connection is kept until it is made or finally
/// refused. Not thread-safe.
class ConnectionRestorer {
 public:
  /// Adds the present connections of the process to the kept connections.
  void Keep(const Catalogue& catalogue, const std::string& process);
  void Drop(const std::string& process);

  /// Returns the connections that can be made now. Returns a connection again only after Settle()
  /// was called for it. Drops a connection silently if a component has returned with another class,
  /// or if the required interface has been connected.
  std::vector<message::ConnectionEnds> TakeDue(const Catalogue& catalogue, SteadyTime now);

  enum class Verdict { kDone, kTryAgain, kStillTrying, kGivenUp };
  /// Called with the outcome of an attempt to make a connection. After a temporary failure, the
  /// connection is due again after a pause, which grows with each failure. Then the verdict is
  /// kTryAgain for the first failure, and kStillTrying for further failures.
  Verdict Settle(const message::ConnectionEnds& ends, const Result<void>& outcome, SteadyTime now);

  /// Returns true if the pause of a connection is over. TakeDue() may then return connections
  /// although the catalogue has not changed.
  [[nodiscard]] bool IsPauseOver(SteadyTime now) const;

 private:
  enum class Readiness { kWaiting, kDue, kPointless };
  struct WaitingConnection {
    message::ConnectionEnds ends;
    std::string required_class;
    std::string provided_class;  ///< empty: not known
    bool is_ordered = false;
    Backoff backoff{std::chrono::milliseconds(200), std::chrono::milliseconds(5000)};
    SteadyTime not_before{};
  };

  static Readiness Judge(const WaitingConnection& kept, const Catalogue& catalogue);

  std::vector<WaitingConnection> kept_;
};

}  // namespace tendon::server
