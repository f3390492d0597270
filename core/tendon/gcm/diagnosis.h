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
  std::string text;                  ///< what was found, or what would be checked
  std::string fix;                   ///< kBad: what to do
  std::vector<std::string> details;  ///< each member that does not match

  bool operator==(const DiagnosisStep&) const = default;
};

/// What one of the two processes still has of a connection that is not active, or never was.
struct Remainder {
  enum class Verdict { kNothing, kSomething, kUnknown };

  std::string process;
  Verdict verdict = Verdict::kUnknown;
  std::string text;  ///< "nothing in robot"

  bool operator==(const Remainder&) const = default;
};

/// Why a connection works, or does not: the same seven steps in the console and in the window.
struct Diagnosis {
  message::Wire wire;
  std::vector<DiagnosisStep> steps;   ///< all seven; those after a bad one were not reached
  std::optional<Error> failure;       ///< of the bad step
  bool is_connected = false;          ///< as `wire` says; if not, and no step is bad, it could be
  std::vector<Remainder> remainders;  ///< of both processes if not active and asked
};

/// Checks what the catalogue knows: the presence of processes and components, that the required
/// interface is free, the signatures, and the state of a wanted connection. Errors: kInvalid;
/// kNotFound if an end is not in the catalogue, unless a connection waits for it.
Result<Diagnosis> Diagnose(const Catalogue& catalogue, const message::Wire& wire);

/// Adds flaws of an active connection, which the catalogue does not know: losses to step 6, delays
/// to step 7. Does nothing if a step is bad already.
void AddHealth(Diagnosis& diagnosis, const std::vector<ConnectionFlaw>& flaws);

/// Whether the required side still tries to reach the provider, and so may know the problem.
[[nodiscard]] bool IsTrying(const Diagnosis& diagnosis);

/// Adds how long the provider's process took to answer this host, or why it did not: to the last
/// step if the connection was made, else to the step "the processes reach each other". kTimeout
/// means reached, but silent. Does nothing if a step is bad, unless IsTrying().
void AddRoundTrip(Diagnosis& diagnosis, const Result<std::chrono::microseconds>& round_trip);

/// Adds to step 2 of an active connection that a component at one end does not run, which may
/// explain later problems.
void AddActivity(Diagnosis& diagnosis, const Catalogue& catalogue);

/// Adds whether both processes have removed a refused or failed connection: the required side from
/// the catalogue, the provider from the answer of GcmClient::GetServed(). Does nothing if the
/// connection is wanted, because its required side keeps trying.
void AddRemainders(Diagnosis& diagnosis, const Catalogue& catalogue,
                   const Result<ConnectionCounts>& served);

/// The remedy if `host` could not reach process `name`: it is silent or absent, or `host` has no
/// route to it, which is not the fault of the process.
[[nodiscard]] std::string FixOfUnreached(const std::string& name, const std::string& host,
                                         const Error& reason);

/// A provided interface to which a required one might be connected.
struct Candidate {
  InterfaceName provided;
  Compatibility compatibility;
  bool is_connected = false;  ///< to the required interface in question
};

/// The provided interfaces of present processes with at least one matching member, the best first:
/// those that fit, then by the number of matching members, then by name. Errors of
/// LookUpRequired().
Result<std::vector<Candidate>> RankCandidates(const Catalogue& catalogue,
                                              const InterfaceName& required);

}  // namespace tendon
