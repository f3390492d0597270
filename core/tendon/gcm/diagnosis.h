#pragma once

#include <tendon/base/result.h>
#include <tendon/gcm/catalog.h>
#include <tendon/gcm/wiring/connection_health.h>
#include <tendon/interface/compatibility.h>
#include <tendon/process/membership_messages.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace tendon {

/// One step of the way to a connection that works.
struct DiagnosisStep {
  enum class Verdict { kGood, kBad, kNotReached };

  Verdict verdict = Verdict::kNotReached;
  std::string text;                  ///< what was found, or what would be looked at
  std::string fix;                   ///< kBad: what to do
  std::vector<std::string> details;  ///< each member that does not match

  bool operator==(const DiagnosisStep&) const = default;
};

/// What is left of a connection that does not stand in one of its two processes.
struct Remainder {
  enum class Verdict { kNothing, kSomething, kUnknown };

  std::string process;
  Verdict verdict = Verdict::kUnknown;
  std::string text;  ///< "nothing of it is left in robot"

  bool operator==(const Remainder&) const = default;
};

/// Why a connection stands, or does not: the same seven steps in the console and in the window.
struct Diagnosis {
  message::Wire wire;
  std::vector<DiagnosisStep> steps;   ///< all seven; those behind a bad one were not reached
  std::optional<Error> failure;       ///< of the step that is bad
  bool is_connected = false;          ///< as the wire says; else it could be, if nothing is bad
  std::vector<Remainder> remainders;  ///< of both processes, where it does not stand and was asked
};

/// Checks what the catalogue knows: processes, components, that the required interface is free,
/// signatures, and how the connection is doing where it is wanted already. Errors: kInvalid and
/// kNotFound where an end is not in the catalogue at all, unless a connection waits for it.
Result<Diagnosis> Diagnose(const Catalog& catalog, const message::Wire& wire);

/// What is wrong with a connection that stands, which a catalogue cannot know either: what it loses
/// is of step 6, what is late of step 7. Does nothing where a step is bad already.
void AddHealth(Diagnosis& diagnosis, const std::vector<ConnectionFlaw>& flaws);

/// Whether the required side still tries to reach the provider: what is wrong may be known to who
/// tries that, too.
[[nodiscard]] bool IsTrying(const Diagnosis& diagnosis);

/// What a catalogue cannot know: how long the provider's process took to answer us, on this host,
/// or why it did not: of the last step where the connection was made, else of that at which the
/// processes reach each other. kTimeout: it is reached, and silent. Does nothing where a step is
/// bad, unless IsTrying().
void AddRoundTrip(Diagnosis& diagnosis, const Result<std::chrono::microseconds>& round_trip);

/// Of a connection that stands: whether a component at one of its ends does not run, so that it is
/// of little use. That is of step 2, which it did not keep from being made; what is wrong behind it
/// may come of it.
void AddActivity(Diagnosis& diagnosis, const Catalog& catalog);

/// Whether both processes are rid of a connection that was refused, or has failed: what the
/// catalogue says of the required side, and what GcmClient::GetServed() has heard from the
/// provider. Does nothing where the connection is wanted, so that its required side goes on trying.
void AddRemainders(Diagnosis& diagnosis, const Catalog& catalog,
                   const Result<ConnectionCounts>& served);

/// What to do where process `name` was looked for from `host` and not reached: where it is silent,
/// not there, or `host` has no route to it, which is no fault of the process.
[[nodiscard]] std::string FixOfUnreached(const std::string& name, const std::string& host,
                                         const Error& reason);

/// A provided interface that a required one might be connected to.
struct Candidate {
  InterfaceName provided;
  Compatibility compatibility;
  bool is_connected = false;  ///< to the one that asks
};

/// The provided interfaces of processes that are there with which at least one member fits, the
/// best first: those that fit, then by how much of them does, then by name. Errors of
/// LookUpRequired().
Result<std::vector<Candidate>> RankCandidates(const Catalog& catalog,
                                              const InterfaceName& required);

}  // namespace tendon
