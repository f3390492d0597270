#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalogue.h>
#include <tendon/gcm/connection_health.h>
#include <tendon/interface/compatibility.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// One step of the check of a connection.
struct DiagnosisStep {
  enum class Verdict { kGood, kBad, kNotReached };

  Verdict verdict = Verdict::kNotReached;
  std::string text;  ///< the result; if the step was not reached, the condition that it checks
  std::string fix;   ///< kBad: the remedy
  std::vector<std::string> details;  ///< a text for each member that does not match

  bool operator==(const DiagnosisStep&) const = default;
};

/// The part of an inactive connection that one of the two processes may still have.
struct ConnectionRemnant {
  enum class Verdict { kNothing, kSomething, kUnknown };

  std::string process;
  Verdict verdict = Verdict::kUnknown;
  std::string text;  ///< "nothing in robot"

  bool operator==(const ConnectionRemnant&) const = default;
};

/// The result of checking a connection in seven steps; it says why the connection works or fails.
/// If no step is bad and the interfaces are not connected, they can be connected. The console and
/// the window show the same steps.
struct Diagnosis {
  message::ConnectionEnds ends;
  /// All seven steps. The steps after a bad step were not reached.
  std::vector<DiagnosisStep> steps;
  std::optional<Error> failure;  ///< error of the bad step
  bool is_connected = false;     ///< true if the required side is present and has this connection
  std::vector<ConnectionRemnant> remnants;  ///< of both processes; see AddRemnants()
};

/// Makes the checks that need only the catalogue: the processes are present, the components are not
/// faulted, the required interface is free, the signatures match, and a requested connection is
/// active. Fails with kInvalid for an invalid name, and with kNotFound if an interface is not in
/// the catalogue. A missing provided interface is only a bad step if the required interface already
/// waits for it.
Result<Diagnosis> Diagnose(const Catalogue& catalogue, const message::ConnectionEnds& ends);

/// Adds the flaws of an active connection, which the catalogue does not contain. Marks step 7 as
/// bad for a long round trip, and step 6 for other flaws. Does nothing if a step is already bad.
void AddHealth(Diagnosis& diagnosis, const std::vector<ConnectionFlaw>& flaws);

/// Returns true if the connection is pending because the required side still tries to reach the
/// provider. Then the reported reason is current.
[[nodiscard]] bool IsTrying(const Diagnosis& diagnosis);

/// Adds the round-trip time from this host to the provider's process to the last step. If there was
/// no reply, adds the reason instead: to the last step if the processes reach each other,
/// otherwise to the step "the processes reach each other". The reason kTimeout means that the
/// process was reached, but did not answer.
///
/// Does nothing if a step is bad, unless IsTrying() is true.
void AddRoundTrip(Diagnosis& diagnosis, const Result<std::chrono::microseconds>& round_trip);

/// Marks step 2 as bad if the connection is made, but one of its components is not active, because
/// this may explain later problems.
void AddActivity(Diagnosis& diagnosis, const Catalogue& catalogue);

/// Adds `remnants` for a refused or failed connection. They say whether each of the two processes
/// has removed the connection. For the required side, the catalogue has this information. For the
/// provider, `served` is the reply of GcmClient::GetProviderCounts(). Does nothing if the required
/// side still has the connection.
void AddRemnants(Diagnosis& diagnosis, const Catalogue& catalogue,
                 const Result<ConnectionCounts>& served);

/// Returns true if the connection is not active, but the required side keeps it and tries again to
/// make it.
[[nodiscard]] bool IsKept(const Diagnosis& diagnosis);

/// Returns the remnants of an inactive connection as text. Each remnant becomes one line, such as
/// "left over: nothing in robot". If IsKept() is true, returns one line instead: "requested: desk
/// makes the connection as soon as possible".
[[nodiscard]] std::vector<std::string> LeftoverTexts(const Diagnosis& diagnosis);

/// Returns the remedy if `host` could not reach process `name`. The remedy depends on `reason`: no
/// route to the process, no reply, or no connection.
[[nodiscard]] std::string FixOfUnreached(const std::string& name, const std::string& host,
                                         const Error& reason);

/// A provided interface that might be connected to a required interface.
struct ProviderCandidate {
  InterfaceName provided;
  Compatibility compatibility;
  bool is_connected = false;  ///< true if the required interface is connected to it now
};

/// Returns the provided interfaces of present processes that have at least one matching member.
/// Interfaces that fit come first. The rest of the order is by number of matching members, number
/// of mismatches, and name. Fails like LookUpRequired().
Result<std::vector<ProviderCandidate>> RankCandidates(const Catalogue& catalogue,
                                                      const InterfaceName& required);

}  // namespace tendon
