#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <string>
#include <vector>

namespace tendon::server {

/// The connections of processes that are gone, which they get back when they return and both ends
/// are there again. Each is kept until it was made or refused for good. Not thread-safe.
class HandBacks {
 public:
  /// Keeps the connections which the process owns now, besides those it was not given back yet.
  void Keep(const Catalog& catalog, const std::string& process);
  void Drop(const std::string& process);

  /// Those to be ordered now; none is given again before Settle() was told its outcome. One whose
  /// end has returned with another class, or whose required interface was connected meanwhile, is
  /// forgotten silently.
  std::vector<message::Wire> TakeDue(const Catalog& catalog, SteadyTime now);

  enum class Verdict { kDone, kTryAgain, kStillTrying, kGivenUp };
  /// What became of an order. What was not made for a reason that may pass is tried again, after a
  /// pause that grows: kTryAgain for the first time, then kStillTrying.
  Verdict Settle(const message::Wire& wire, const Result<void>& outcome, SteadyTime now);

  /// Whether a pause is over: TakeDue() may have something without a change of the catalogue.
  [[nodiscard]] bool IsPauseOver(SteadyTime now) const;

 private:
  enum class Readiness { kWaiting, kDue, kPointless };
  struct Kept {
    message::Wire wire;
    std::string required_class;
    std::string provided_class;  ///< empty: was not known
    bool is_ordered = false;
    std::chrono::milliseconds pause{0};  ///< after the last failure
    SteadyTime not_before{};
  };

  static Readiness Judge(const Kept& kept, const Catalog& catalog);

  std::vector<Kept> kept_;
};

}  // namespace tendon::server
