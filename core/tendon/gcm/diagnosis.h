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
  std::string fix;                   ///< kBad: the remedy
  std::vector<std::string> details;  ///< each member that does not match

  bool operator==(const DiagnosisStep&) const = default;
};

/// The rest of an inactive connection in one of its two processes.
struct ConnectionRemnant {
  enum class Verdict { kNothing, kSomething, kUnknown };

  std::string process;
  Verdict verdict = Verdict::kUnknown;
  std::string text;  ///< "nothing in robot"

  bool operator==(const ConnectionRemnant&) const = default;
};

/// The check of a connection in seven steps: why it works or fails. If no step is bad and it is not
/// connected, it can be connected. The console and the window show the same steps.
struct Diagnosis {
  message::Wire wire;
  std::vector<DiagnosisStep> steps;         ///< all seven; those after a bad one were not reached
  std::optional<Error> failure;             ///< error of the bad step
  bool is_connected = false;                ///< the present required side has this connection
  std::vector<ConnectionRemnant> remnants;  ///< of both processes; see AddRemnants()
};

/// Makes the checks that need only the catalogue: that processes and components are present, that
/// the required interface is free, the signatures, and the state of a requested connection. Errors:
/// kInvalid; kNotFound if an end is not in the catalogue, unless a connection waits for it.
Result<Diagnosis> Diagnose(const Catalogue& catalogue, const message::Wire& wire);

/// Adds flaws of an active connection, which the catalogue does not know: losses to step 6, delays
/// to step 7. Does nothing if a step is bad already.
void AddHealth(Diagnosis& diagnosis, const std::vector<ConnectionFlaw>& flaws);

/// True if the required side still tries to reach the provider, so that its reason is current.
[[nodiscard]] bool IsTrying(const Diagnosis& diagnosis);

/// Adds the round-trip time from this host to the provider's process, or the reason why there was
/// no answer. Adds it to the last step if the connection was made, otherwise to the step "the
/// processes reach each other". kTimeout means that the process was reached, but did not answer.
/// Does nothing if a step is bad, unless IsTrying() is true.
void AddRoundTrip(Diagnosis& diagnosis, const Result<std::chrono::microseconds>& round_trip);

/// Adds a note to step 2 of an active connection if a component at one end does not run, which may
/// explain later problems.
void AddActivity(Diagnosis& diagnosis, const Catalogue& catalogue);

/// Adds `remnants`, which say for both processes whether they have removed a refused or failed
/// connection. The catalogue knows this about the required side. For the provider, `served` is the
/// answer of GcmClient::GetProviderCounts(). Does nothing for a requested connection, because its
/// required side keeps trying.
void AddRemnants(Diagnosis& diagnosis, const Catalogue& catalogue,
                 const Result<ConnectionCounts>& served);

/// True if the required side keeps an inactive connection, and makes it as soon as it can.
[[nodiscard]] bool IsKept(const Diagnosis& diagnosis);

/// The remnants of an inactive connection as text, one line for each process that was asked: "left
/// over: nothing in robot"; or one line if the connection is kept: "requested: desk makes the
/// connection as soon as possible". The text is also correct if nobody has tried to make the
/// connection.
[[nodiscard]] std::vector<std::string> LeftoverTexts(const Diagnosis& diagnosis);

/// The remedy if `host` could not reach process `name`: the process is silent or absent, or `host`
/// has no route to it.
[[nodiscard]] std::string FixOfUnreached(const std::string& name, const std::string& host,
                                         const Error& reason);

/// A provided interface to which a required interface might be connected.
struct ProviderCandidate {
  InterfaceName provided;
  Compatibility compatibility;
  bool is_connected = false;  ///< to the required interface in question
};

/// The provided interfaces of present processes with at least one matching member, the best first:
/// those that fit, then by the number of matching members, then by name. Errors of
/// LookUpRequired().
Result<std::vector<ProviderCandidate>> RankCandidates(const Catalogue& catalogue,
                                                      const InterfaceName& required);

}  // namespace tendon
