#include <tendon/gcm/diagnosis.h>

#include <tendon/base/os/process.h>
#include <tendon/base/os/route.h>
#include <tendon/gcm/lookup.h>
#include <tendon/process/membership/advertised_address.h>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace tendon {
namespace {

using Verdict = DiagnosisStep::Verdict;

/// The text of each step while the check has not reached it.
constexpr std::array kSteps = {"both processes are available",
                               "both components are active",
                               "the required interface is free",
                               "the signatures match",
                               "the processes reach each other",
                               "the connection is made",
                               "the provider answers"};

/// Indices in kSteps: "both components are active", "the processes reach each other" and "the
/// connection is made".
constexpr std::size_t kActive = 1;
constexpr std::size_t kReached = 4;
constexpr std::size_t kMade = 5;

/// Collects the results of the checks, up to the first bad one.
class Examination {
 public:
  explicit Examination(const message::ConnectionEnds& ends) { diagnosis_.ends = ends; }

  [[nodiscard]] bool goes_on() const { return !diagnosis_.failure; }
  void Good(const std::string& text) { diagnosis_.steps.push_back({Verdict::kGood, text, {}, {}}); }
  void Bad(ErrorCode code, const std::string& text, const std::string& fix,
           std::vector<std::string> details = {}) {
    diagnosis_.steps.push_back({Verdict::kBad, text, fix, std::move(details)});
    diagnosis_.failure = Error{code, text + (fix.empty() ? "" : "; " + fix)};
  }
  /// Sets Diagnosis::is_connected from the catalogue. Sets it to false if the required side is
  /// absent, because only the required side knows its connections.
  void SetConnected(const Catalogue& catalogue) {
    const message::ConnectionEnds& ends = diagnosis_.ends;
    const ProcessEntry* owner = catalogue.FindProcess(ends.required.process);
    const auto* now = catalogue.FindConnection(ends.required);
    diagnosis_.is_connected = owner != nullptr && IsPresent(owner->process) && now != nullptr &&
                              now->provided == ends.provided;
  }

  Diagnosis Take() && {
    while (diagnosis_.steps.size() < kSteps.size()) {
      diagnosis_.steps.push_back({Verdict::kNotReached, kSteps[diagnosis_.steps.size()], {}, {}});
    }
    return std::move(diagnosis_);
  }

 private:
  Diagnosis diagnosis_;
};

/// Handles a connection that waits for a provided interface that is not in the catalogue.
void CheckAbsent(const Catalogue& catalogue, const message::ConnectionEnds& ends,
                 const Error& missing, Examination& examination) {
  const ProcessEntry* provider = catalogue.FindProcess(ends.provided.process);
  if (provider != nullptr && IsPresent(provider->process)) {
    examination.Good("process " + ends.provided.process + " is available");
  }
  examination.Bad(missing.code, missing.message,
                  "start this process (the connection is made when the process joins); or, to "
                  "cancel the connection: gcm disconnect " +
                      ToString(ends.required));
}

void CheckProcesses(const ProcessDescription& required, const ProcessDescription& provided,
                    Examination& examination) {
  for (const ProcessDescription* process : {&required, &provided}) {
    if (IsPresent(*process)) continue;
    const std::string reason = process->reason.empty() ? "" : " (" + process->reason + ")";
    return examination.Bad(
        ErrorCode::kUnreachable,
        "process '" + process->name + "' is " + std::string(ToString(process->state)) + reason,
        AdviceFor(*process));
  }
  const bool is_one = required.name == provided.name;
  examination.Good(is_one
                       ? "process " + required.name + " is available"
                       : "processes " + required.name + " and " + provided.name + " are available");
}

void CheckComponents(const ComponentDescription& required, const ComponentDescription& provided,
                     Examination& examination) {
  for (const ComponentDescription* component : {&required, &provided}) {
    if (component->state != ComponentState::kFaulted) continue;
    return examination.Bad(ErrorCode::kFailed,
                           "component '" + component->name + "' is faulted: " + component->fault,
                           "start the component again");
  }
  examination.Good(required.name + " is " + std::string(ToString(required.state)) + ", " +
                   provided.name + " is " + std::string(ToString(provided.state)));
}

/// Step 3: the current connection of the required interface.
void CheckFree(const Catalogue& catalogue, const message::ConnectionEnds& ends,
               Examination& examination) {
  const auto* connection = catalogue.FindConnection(ends.required);
  if (connection == nullptr) return examination.Good(ToString(ends.required) + " is free");
  if (connection->provided == ends.provided) return examination.Good("the connection is requested");
  examination.Bad(ErrorCode::kExists,
                  ToString(ends.required) + " is connected to " + ToString(connection->provided),
                  "to replace this connection: gcm connect " + ToString(ends.required) + " " +
                      ToString(ends.provided) + " --replace");
}

void CheckSignatures(const message::ConnectionEnds& ends, const RequiredDescription& required,
                     const ProvidedDescription& provided, Examination& examination) {
  const Compatibility compatibility = Compare(required, provided);
  const std::string text = "signatures match: " + std::to_string(compatibility.matched) + " of " +
                           std::to_string(compatibility.needed);
  if (compatibility.fits()) return examination.Good(text);
  std::vector<std::string> details;
  for (const Mismatch& one : compatibility.mismatches) details.push_back(one.text);
  examination.Bad(ErrorCode::kIncompatible, text,
                  "to list the compatible interfaces: gcm candidates " + ToString(ends.required),
                  std::move(details));
}

/// Returns true if the provider announces a loopback address, but the required side is on another
/// host.
bool IsOutOfReach(const ProcessDescription& required, const ProcessDescription& provided) {
  return IsOfOneHost(provided.address) && required.host != provided.host;
}

std::string SeenFrom(const std::string& host) { return " (seen from host " + host + ")"; }

/// Returns the remedy for a pending connection. The process retries the connection, but may never
/// succeed.
std::string FixOfPending(const ProcessDescription& required, const ProcessDescription& provided,
                         const std::string& reason) {
  if (os::IsNoRouteError(reason)) {
    return FixOfUnreached(provided.name, required.host, {ErrorCode::kUnreachable, reason});
  }
  if (!provided.reason.empty()) return provided.name + " " + provided.reason;
  return "the connection is retried automatically; check process " + provided.name;
}

/// Makes steps 5 and 6 of the check.
void CheckConnection(const Catalogue& catalogue, const message::ConnectionEnds& ends,
                     Examination& examination) {
  const ProcessDescription& required = catalogue.FindProcess(ends.required.process)->process;
  const ProcessDescription& provided = catalogue.FindProcess(ends.provided.process)->process;
  const auto* connection = catalogue.FindConnection(ends.required);
  if (IsOutOfReach(required, provided)) {
    return examination.Bad(ErrorCode::kUnreachable,
                           required.name + " on host " + required.host + " cannot reach " +
                               provided.name + " at " + provided.address,
                           "start " + provided.name +
                               " with --listen and --advertise and an address of host " +
                               provided.host);
  }
  if (connection == nullptr) return;  // nobody has requested the connection
  if (connection->state == ConnectionState::kPending) {
    return examination.Bad(
        ErrorCode::kTimeout,
        "the connection is pending: " + connection->reason + SeenFrom(required.host),
        FixOfPending(required, provided, connection->reason));
  }
  examination.Good(required.name == provided.name
                       ? "both ends are in one process"
                       : required.name + " reaches " + provided.name + " at " + provided.address);
  if (connection->state == ConnectionState::kActive)
    return examination.Good("the connection is made");
  examination.Bad(ErrorCode::kFailed, "the connection was refused: " + connection->reason,
                  "to end the connection: gcm disconnect " + ToString(ends.required));
}

ConnectionRemnant LeftAtRequired(const Catalogue& catalogue, const message::ConnectionEnds& ends) {
  using Kind = ConnectionRemnant::Verdict;
  const std::string& process = ends.required.process;
  const ProcessEntry* entry = catalogue.FindProcess(process);
  if (entry == nullptr || !IsPresent(entry->process)) {
    return {process, Kind::kUnknown, "unknown, because process '" + process + "' is not available"};
  }
  const auto* other = catalogue.FindConnection(ends.required);
  const std::string nothing = "nothing in " + process;
  if (other == nullptr) return {process, Kind::kNothing, nothing};
  return {process, Kind::kNothing,
          nothing + ", where " + ends.required.component + "/" + ends.required.interface +
              " is connected to " + ToString(other->provided)};
}

ConnectionRemnant LeftAtProvider(const Catalogue& catalogue, const message::ConnectionEnds& ends,
                                 const Result<ConnectionCounts>& served) {
  using Kind = ConnectionRemnant::Verdict;
  const std::string& process = ends.provided.process;
  if (!served && served.error().code != ErrorCode::kNotFound) {
    return {
        process, Kind::kUnknown,
        "unknown, because process '" + process +
            "' does not report whether it still serves the connection: " + served.error().message};
  }
  const auto* other = catalogue.FindConnection(ends.required);
  const bool serves_another = other != nullptr && other->provided.process == process;
  if (!served || serves_another) {
    return {process, Kind::kNothing, "nothing in " + process};
  }
  return {process, Kind::kSomething,
          process + " still serves " + ToString(ends.required) +
              ", although this connection does not exist any more; that process stops serving it "
              "when the link between the two processes ends"};
}

/// The rank of a candidate; a smaller one is better.
auto RankOf(const ProviderCandidate& candidate) {
  const Compatibility& how = candidate.compatibility;
  return std::tuple(!how.fits(), -how.matched, how.mismatches.size(), candidate.provided);
}

}  // namespace

Result<Diagnosis> Diagnose(const Catalogue& catalogue, const message::ConnectionEnds& ends) {
  const auto required = LookUpRequired(catalogue, ends.required);
  if (!required) return required.error();
  const auto provided = LookUpProvided(catalogue, ends.provided);
  Examination examination(ends);
  examination.SetConnected(catalogue);
  if (!provided) {
    const auto* connection = catalogue.FindConnection(ends.required);
    if (connection == nullptr || connection->provided != ends.provided) return provided.error();
    CheckAbsent(catalogue, ends, provided.error(), examination);
    return std::move(examination).Take();
  }
  CheckProcesses(catalogue.FindProcess(ends.required.process)->process,
                 catalogue.FindProcess(ends.provided.process)->process, examination);
  if (examination.goes_on()) {
    CheckComponents(*catalogue.FindComponent(ends.required.process, ends.required.component),
                    *catalogue.FindComponent(ends.provided.process, ends.provided.component),
                    examination);
  }
  if (examination.goes_on()) CheckFree(catalogue, ends, examination);
  if (examination.goes_on()) CheckSignatures(ends, **required, **provided, examination);
  if (examination.goes_on()) CheckConnection(catalogue, ends, examination);
  return std::move(examination).Take();
}

void AddHealth(Diagnosis& diagnosis, const std::vector<ConnectionFlaw>& flaws) {
  if (diagnosis.failure || flaws.empty()) return;
  const std::string& provider = diagnosis.ends.provided.process;
  const bool is_late = flaws.front().kind == ConnectionFlaw::Kind::kLate;
  DiagnosisStep& step = is_late ? diagnosis.steps.back() : diagnosis.steps.at(kMade);
  std::string text = is_late ? "process '" + provider + "' " : "the connection is made, but ";
  for (const ConnectionFlaw& flaw : flaws) {
    text += (&flaw == &flaws.front() ? "" : "; ") + ToString(flaw);
  }
  step = {Verdict::kBad,
          text,
          is_late ? "check process '" + provider + "' and the network between the two processes"
                  : "to find the component that is too slow: gcm top",
          {}};
  diagnosis.failure = Error{ErrorCode::kFailed, step.text + "; " + step.fix};
}

bool IsTrying(const Diagnosis& diagnosis) {
  return diagnosis.failure && diagnosis.steps.at(kReached).verdict == Verdict::kBad &&
         diagnosis.failure->code == ErrorCode::kTimeout;
}

void AddRoundTrip(Diagnosis& diagnosis, const Result<std::chrono::microseconds>& round_trip) {
  const bool is_trying = IsTrying(diagnosis);
  if (diagnosis.failure && !is_trying) return;
  const std::string& name = diagnosis.ends.provided.process;
  const std::string process = "process '" + name + "'";
  if (round_trip) {
    if (is_trying) return;
    diagnosis.steps.back() = {Verdict::kGood,
                              process + " answers within " + std::to_string(round_trip->count()) +
                                  " us" + SeenFrom(os::HostName()),
                              {},
                              {}};
    return;
  }
  const bool is_made = diagnosis.steps.at(kReached).verdict == Verdict::kGood;
  DiagnosisStep& step = is_made ? diagnosis.steps.back() : diagnosis.steps.at(kReached);
  // The required side has already reported a more precise reason.
  if (is_trying && os::IsNoRouteError(step.text)) return;
  const std::string fix = FixOfUnreached(name, os::HostName(), round_trip.error());
  step = {Verdict::kBad,
          is_trying ? step.text : round_trip.error().message + SeenFrom(os::HostName()),
          fix,
          {}};
  diagnosis.failure = Error{round_trip.error().code, step.text + "; " + fix};
}

bool IsKept(const Diagnosis& diagnosis) {
  const bool is_made =
      diagnosis.steps.size() > kMade && diagnosis.steps[kMade].verdict != Verdict::kNotReached;
  return diagnosis.is_connected && diagnosis.failure.has_value() && !is_made;
}

std::vector<std::string> LeftoverTexts(const Diagnosis& diagnosis) {
  if (IsKept(diagnosis)) {
    return {"requested: " + diagnosis.ends.required.process +
            " makes the connection as soon as possible"};
  }
  std::vector<std::string> texts;
  for (const ConnectionRemnant& one : diagnosis.remnants) texts.push_back("left over: " + one.text);
  return texts;
}

std::string FixOfUnreached(const std::string& name, const std::string& host, const Error& reason) {
  if (os::IsNoRouteError(reason.message)) {
    return "give host " + host +
           " a route to this address; or, if that host can reach another address of the process, "
           "start " +
           name + " with --advertise and that address";
  }
  if (reason.code == ErrorCode::kTimeout) return "check process '" + name + "': it may hang";
  return "check that " + name +
         " listens at this address and that no firewall blocks the connection; if the address is "
         "wrong, start " +
         name + " with --advertise and an address that can be reached";
}

void AddActivity(Diagnosis& diagnosis, const Catalogue& catalogue) {
  const bool stands =
      diagnosis.is_connected && diagnosis.steps.at(kReached).verdict == Verdict::kGood;
  if (!stands) return;
  for (const InterfaceName* end : {&diagnosis.ends.required, &diagnosis.ends.provided}) {
    const auto* component = catalogue.FindComponent(end->process, end->component);
    if (component == nullptr || component->state == ComponentState::kActive) continue;
    const std::string effect = end == &diagnosis.ends.required
                                   ? "it makes no calls"
                                   : "it refuses commands, and its reads return old values";
    DiagnosisStep& step = diagnosis.steps.at(kActive);
    step = {Verdict::kBad,
            component->name + " is " + std::string(ToString(component->state)) + ": " + effect,
            "gcm start " + end->process + "/" + end->component,
            {}};
    diagnosis.failure = Error{ErrorCode::kFailed, step.text + "; " + step.fix};
    return;
  }
}

void AddRemnants(Diagnosis& diagnosis, const Catalogue& catalogue,
                 const Result<ConnectionCounts>& served) {
  const message::ConnectionEnds& ends = diagnosis.ends;
  if (diagnosis.is_connected) return;
  diagnosis.remnants = {LeftAtRequired(catalogue, ends)};
  if (ends.provided.process == ends.required.process) return;
  diagnosis.remnants.push_back(LeftAtProvider(catalogue, ends, served));
}

Result<std::vector<ProviderCandidate>> RankCandidates(const Catalogue& catalogue,
                                                      const InterfaceName& required) {
  const auto wanted = LookUpRequired(catalogue, required);
  if (!wanted) return wanted.error();
  const auto* connection = catalogue.FindConnection(required);
  std::vector<ProviderCandidate> candidates;
  for (const auto& [process, entry] : catalogue.processes()) {
    if (!IsPresent(entry.process)) continue;
    for (const auto& [component, description] : entry.components) {
      for (const ProvidedDescription& provided : description.provided) {
        ProviderCandidate candidate{{process, component, provided.name},
                                    Compare(**wanted, provided)};
        if (candidate.compatibility.matched == 0) continue;
        candidate.is_connected =
            connection != nullptr && connection->provided == candidate.provided;
        candidates.push_back(std::move(candidate));
      }
    }
  }
  std::sort(
      candidates.begin(), candidates.end(),
      [](const ProviderCandidate& a, const ProviderCandidate& b) { return RankOf(a) < RankOf(b); });
  return candidates;
}

}  // namespace tendon
