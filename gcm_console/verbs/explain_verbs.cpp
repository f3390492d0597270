#include <gcm_console/output/table.h>
#include <gcm_console/verbs/connection_checks.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/gcm/diagnosis.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <thread>
#include <vector>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Catalogue;
using tendon::Diagnosis;
using tendon::DiagnosisStep;
using tendon::Error;
using tendon::ErrorCode;
using tendon::InterfaceName;
using tendon::ProviderCandidate;
using tendon::Result;

/// Returns the matched and the needed members: "7 of 9".
std::string Share(const ProviderCandidate& candidate) {
  return std::to_string(candidate.compatibility.matched) + " of " +
         std::to_string(candidate.compatibility.needed);
}

ordered_json CandidateJson(const ProviderCandidate& candidate) {
  ordered_json mismatches = ordered_json::array();
  for (const auto& one : candidate.compatibility.mismatches) mismatches.push_back(one.text);
  return {{"provided", ToString(candidate.provided)},   {"fits", candidate.compatibility.fits()},
          {"matched", candidate.compatibility.matched}, {"needed", candidate.compatibility.needed},
          {"connected", candidate.is_connected},        {"mismatches", std::move(mismatches)}};
}

Result<ExitCode> Candidates(Context& context, const std::string& text) {
  const auto required = tendon::ParseInterfaceName(text);
  if (!required) return required.error();
  const auto client = context.Client();
  if (!client) return client.error();
  LearnConflictingTypes(context);
  const auto candidates = RankCandidates((*client)->catalogue(), *required);
  if (!candidates) return candidates.error();
  if (context.settings().json) {
    ordered_json all = ordered_json::array();
    for (const ProviderCandidate& candidate : *candidates) all.push_back(CandidateJson(candidate));
    context.PrintJson({{"required", text}, {"candidates", std::move(all)}});
    return program::kOk;
  }
  Table table({"PROVIDED", "FITS", "MATCHED", "WHY NOT"});
  for (const ProviderCandidate& candidate : *candidates) {
    const std::string fits = candidate.is_connected           ? "connected"
                             : candidate.compatibility.fits() ? "yes"
                                                              : "no";
    table.Add(
        {ToString(candidate.provided), fits, Share(candidate), candidate.compatibility.Text()});
  }
  context.Print(table);
  return program::kOk;
}

/// Returns the provided interface to explain if the user has named none: the connected one; if
/// there is none, the best candidate.
Result<InterfaceName> LikelyProvider(const Catalogue& catalogue, const InterfaceName& required) {
  if (const auto* connection = catalogue.FindConnection(required)) return connection->provided;
  const auto candidates = RankCandidates(catalogue, required);
  if (!candidates) return candidates.error();
  if (!candidates->empty()) return candidates->front().provided;
  return Error{
      ErrorCode::kIncompatible,
      ToString(required) + " is not connected, and no available interface is compatible with it"};
}

/// Measures the time of a request that the process answers without a thread of a component.
Result<std::chrono::microseconds> RoundTrip(Context& context, const std::string& process) {
  const auto begin = std::chrono::steady_clock::now();
  const auto reply = context.Ask<tendon::message::ProgramVersion>(
      [&](tendon::GcmClient& client, auto handler) { client.GetVersion(process, handler); });
  if (!reply) return reply.error();
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() -
                                                               begin);
}

/// Returns the problems of a working connection, found by comparing two replies of its process.
std::vector<tendon::ConnectionFlaw> AskForFlaws(Context& context, const InterfaceName& required) {
  constexpr std::chrono::milliseconds kBetween(500);
  const auto counts = [&] {
    return context.Ask<tendon::ConnectionCounts>(
        [&](tendon::GcmClient& client, auto handler) { client.GetCounts(required, handler); });
  };
  const auto before = counts();
  if (!before) return {};
  std::this_thread::sleep_for(kBetween);
  const auto now = counts();
  return now ? FlawsOf(*now, *before) : std::vector<tendon::ConnectionFlaw>();
}

Result<tendon::ConnectionCounts> Served(Context& context, const Diagnosis& diagnosis) {
  return context.Ask<tendon::ConnectionCounts>([&](tendon::GcmClient& client, auto handler) {
    client.GetProviderCounts(diagnosis.ends, handler);
  });
}

void Print(const Diagnosis& diagnosis, std::ostream& out) {
  out << ToString(diagnosis.ends.required) << " -> " << ToString(diagnosis.ends.provided) << '\n';
  int number = 0;
  for (const DiagnosisStep& step : diagnosis.steps) {
    const char* verdict = step.verdict == DiagnosisStep::Verdict::kGood  ? "ok  "
                          : step.verdict == DiagnosisStep::Verdict::kBad ? "BAD "
                                                                         : "-   ";
    out << "  " << ++number << ' ' << verdict << Plain(step.text) << '\n';
    for (const auto& detail : step.details) out << "         " << Plain(detail) << '\n';
    if (!step.fix.empty()) out << "         fix: " << Plain(step.fix) << '\n';
  }
  for (const std::string& line : LeftoverTexts(diagnosis)) out << "  " << Plain(line) << '\n';
  if (diagnosis.failure || diagnosis.is_connected) return;
  out << "  next: gcm connect " << ToString(diagnosis.ends.required) << ' '
      << ToString(diagnosis.ends.provided) << '\n';
}

const char* WordOf(tendon::ConnectionRemnant::Verdict verdict) {
  using Verdict = tendon::ConnectionRemnant::Verdict;
  if (verdict == Verdict::kUnknown) return "unknown";
  return verdict == Verdict::kNothing ? "nothing" : "something";
}

ordered_json DiagnosisJson(const Diagnosis& diagnosis) {
  ordered_json steps = ordered_json::array();
  for (const DiagnosisStep& step : diagnosis.steps) {
    const char* verdict = step.verdict == DiagnosisStep::Verdict::kGood  ? "good"
                          : step.verdict == DiagnosisStep::Verdict::kBad ? "bad"
                                                                         : "not reached";
    steps.push_back(
        {{"verdict", verdict}, {"text", step.text}, {"details", step.details}, {"fix", step.fix}});
  }
  ordered_json remnants = ordered_json::array();
  for (const auto& one : diagnosis.remnants) {
    remnants.push_back(
        {{"process", one.process}, {"left", WordOf(one.verdict)}, {"text", one.text}});
  }
  return {{"required", ToString(diagnosis.ends.required)},
          {"provided", ToString(diagnosis.ends.provided)},
          {"connected", diagnosis.is_connected},
          {"kept", IsKept(diagnosis)},
          {"steps", std::move(steps)},
          {"rolled_back", std::move(remnants)}};
}

/// Returns the exit code of a diagnosis. A lost process must not have the exit code of
/// kUnreachable, which means that the GCM is missing.
ExitCode DiagnosisExitCode(const Diagnosis& diagnosis) {
  if (!diagnosis.failure) return program::kOk;
  const ErrorCode code = diagnosis.failure->code;
  return code == ErrorCode::kUnreachable ? program::kRefused : program::ExitCodeOf(code);
}

struct ExplainedEnds {
  std::string required;
  std::string provided;
};

Result<ExitCode> Explain(Context& context, const ExplainedEnds& ends) {
  const auto required = tendon::ParseInterfaceName(ends.required);
  if (!required) return required.error();
  const auto client = context.Client();
  if (!client) return client.error();
  LearnConflictingTypes(context);
  const Catalogue catalogue = (*client)->catalogue();
  const auto provided = ends.provided.empty() ? LikelyProvider(catalogue, *required)
                                              : tendon::ParseInterfaceName(ends.provided);
  if (!provided) return provided.error();
  if (auto good = CheckOrder("explain", catalogue, *required, *provided); !good)
    return good.error();
  auto diagnosis = Diagnose(catalogue, {*required, *provided});
  if (!diagnosis) return diagnosis.error();
  if (!diagnosis->failure && diagnosis->is_connected) {
    AddHealth(*diagnosis, AskForFlaws(context, *required));
  }
  if (!diagnosis->failure || IsTrying(*diagnosis)) {
    AddRoundTrip(*diagnosis, RoundTrip(context, provided->process));
  }
  AddActivity(*diagnosis, catalogue);
  if (!diagnosis->is_connected) AddRemnants(*diagnosis, catalogue, Served(context, *diagnosis));
  if (context.settings().json) {
    context.PrintJson(DiagnosisJson(*diagnosis));
  } else {
    Print(*diagnosis, context.out());
  }
  return DiagnosisExitCode(*diagnosis);
}

}  // namespace

std::vector<Verb> ExplainVerbs() {
  return {
      {"candidates",
       "list the provided interfaces that can be connected to a required interface, the best first",
       [](CLI::App& app) -> Verb::Run {
         auto required = std::make_shared<std::string>();
         WithKind(app.add_option("required", *required, "process/component/interface"),
                  WordKind::kRequired)
             ->required();
         return [required](Context& context) { return Candidates(context, *required); };
       }},
      {"explain", "check a connection step by step, and report why the connection does not work",
       [](CLI::App& app) -> Verb::Run {
         auto ends = std::make_shared<ExplainedEnds>();
         WithKind(app.add_option("required", ends->required, "process/component/interface"),
                  WordKind::kRequired)
             ->required();
         WithKind(app.add_option("provided", ends->provided,
                                 "the provided interface (default: the connected interface; if "
                                 "none is connected, the best candidate)"),
                  WordKind::kProvided);
         return [ends](Context& context) { return Explain(context, *ends); };
       }},
  };
}

}  // namespace console
