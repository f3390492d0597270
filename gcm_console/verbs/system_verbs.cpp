#include <gcm_console/output/table.h>
#include <gcm_console/verbs/connection_checks.h>
#include <gcm_console/verbs/queries.h>
#include <gcm_console/verbs/verb.h>
#include <tendon/base/os/termination.h>
#include <tendon/base/text.h>
#include <tendon/gcm/lifecycle/class_check.h>
#include <tendon/gcm/system/client_executor.h>
#include <tendon/gcm/system/comparison.h>
#include <tendon/gcm/system/component_manager_file.h>
#include <tendon/gcm/system/running_system.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <system_error>
#include <utility>
#include <vector>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Error;
using tendon::ErrorCode;
using tendon::Plan;
using tendon::PlanOutcome;
using tendon::PlanStep;
using tendon::Result;
using tendon::StepOutcome;
using tendon::SystemComparison;
using tendon::SystemDifference;
using tendon::SystemFile;

std::size_t ComponentsOf(const SystemFile& system) {
  std::size_t count = 0;
  for (const auto& process : system.processes) count += process.components.size();
  return count;
}

/// A system file that was made from the running system or from another file.
struct SaveOutcome {
  SystemFile file;
  std::vector<std::string> kept = {};  ///< parts that were kept from the existing file
  std::vector<std::string> left_out = {};
};

struct SaveWords {
  std::string file;
  bool dry_run = false;
};

Result<ExitCode> Write(Context& context, const SaveWords& words, const SaveOutcome& saved) {
  const SystemFile& system = saved.file;
  const auto& [file, is_dry] = words;
  if (const auto text = SystemFileText(system); !text) return text.error();
  if (!is_dry) {
    if (const auto written = WriteSystemFile(file, system); !written) return written.error();
  }
  if (context.settings().json) {
    context.PrintJson({{"file", file},
                       {"processes", system.processes.size()},
                       {"components", ComponentsOf(system)},
                       {"connections", system.connections.size()},
                       {"kept", saved.kept},
                       {"left_out", saved.left_out},
                       {"dry_run", is_dry}});
    return program::kOk;
  }
  context.out() << file << "  " << tendon::Counted(system.processes.size(), "process", "processes")
                << ", " << tendon::Counted(ComponentsOf(system), "component", "components") << ", "
                << tendon::Counted(system.connections.size(), "connection", "connections")
                << (is_dry ? "; would be written" : "") << '\n';
  PrintSentences(saved.kept, context.err());
  PrintSentences(saved.left_out, context.err());
  return program::kOk;
}

struct ImportWords {
  std::string from;
  std::string to;
  std::string process;
  bool dry_run = false;
};

/// Imports a file. Never overwrites a file, because its content would be lost.
Result<ExitCode> Import(Context& context, const ImportWords& words) {
  const auto text = tendon::ReadSystemText(words.from);
  if (!text) return text.error();
  auto imported = tendon::ParseComponentManagerFile(*text, words.from, words.process);
  if (!imported) return imported.error();
  std::error_code ignored;
  if (std::filesystem::exists(words.to, ignored)) {
    return Error{ErrorCode::kExists,
                 words.to + " already exists: give another file, or remove this file"};
  }
  imported->file.name = std::filesystem::path(words.to).stem().string();
  return Write(context, {words.to, words.dry_run},
               {.file = std::move(imported->file), .left_out = std::move(imported->left_out)});
}

/// Returns the present content of the file to update, if the file exists. Returns an error for a
/// file of another kind, because saving would destroy its content.
Result<std::optional<SystemFile>> FormerOf(const std::string& file) {
  auto former = tendon::ReadSystemFile(file);
  if (former) return std::optional(*std::move(former));
  if (former.error().code == ErrorCode::kNotFound) return std::optional<SystemFile>();
  return Error{
      former.error().code,
      former.error().message + "; nothing is saved: give another file, or remove this file"};
}

Result<ExitCode> Save(Context& context, const SaveWords& words) {
  const auto former = FormerOf(words.file);
  if (!former) return former.error();
  const auto client = context.Client();
  if (!client) return client.error();
  const std::string stem = std::filesystem::path(words.file).stem().string();
  const std::string name = *former ? (*former)->name : stem;
  tendon::RunningSystem running = SystemOf((*client)->catalogue(), name);
  std::vector<std::string> kept;
  if (*former) kept = KeepFrom(**former, running);
  const auto children = context.Ask<tendon::message::Children>(
      [](tendon::GcmClient& asked, auto handler) { asked.GetChildren(handler); });
  if (!children) return children.error();
  SetStarts(*children, running.file);
  auto left_out = running.LeftOut();
  return Write(context, words, {std::move(running.file), std::move(kept), std::move(left_out)});
}

struct Marks {
  const char* sign;
  const char* word;
};

Marks MarksOf(SystemDifference::Kind kind) {
  switch (kind) {
    case SystemDifference::Kind::kMissing:
      return {"-", "missing"};
    case SystemDifference::Kind::kExtra:
      return {"+", "extra"};
    case SystemDifference::Kind::kChanged:
      return {"~", "changed"};
  }
  return {"?", "?"};
}

void Print(const SystemComparison& comparison, Context& context) {
  if (context.settings().json) {
    ordered_json all = ordered_json::array();
    for (const SystemDifference& one : comparison.differences) {
      all.push_back({{"kind", MarksOf(one.kind).word}, {"what", one.what}, {"how", one.how}});
    }
    context.PrintJson({{"equal", comparison.equal}, {"differences", std::move(all)}});
    return;
  }
  for (const SystemDifference& one : comparison.differences) {
    context.out() << MarksOf(one.kind).sign << ' ' << Plain(one.what)
                  << (one.how.empty() ? "" : ": " + Plain(one.how)) << '\n';
  }
}

struct DiffWords {
  std::string first;
  std::string second;
};

/// Returns the second file of a comparison; if none was given, the running system.
Result<SystemFile> SecondOf(Context& context, const DiffWords& words) {
  if (!words.second.empty()) return tendon::ReadSystemFile(words.second);
  const auto client = context.Client();
  if (!client) return client.error();
  return SystemOf((*client)->catalogue(), "").file;
}

Result<ExitCode> Diff(Context& context, const DiffWords& words) {
  const auto first = tendon::ReadSystemFile(words.first);
  if (!first) return first.error();
  const auto second = SecondOf(context, words);
  if (!second) return second.error();
  const auto starts =
      words.second.empty() ? tendon::StartComparison::kIgnore : tendon::StartComparison::kCompare;
  const SystemComparison comparison = CompareSystems(*first, *second, starts);
  Print(comparison, context);
  return comparison.differences.empty() ? program::kOk : program::kRefused;
}

ordered_json PlanStepJson(const PlanStep& step) {
  return {{"kind", tendon::ToString(step.kind)},
          {"text", ToString(step)},
          {"takes_away", step.takes_away}};
}

void Print(const Plan& plan, Context& context) {
  if (context.settings().json) {
    ordered_json steps = ordered_json::array();
    for (const PlanStep& step : plan.steps) steps.push_back(PlanStepJson(step));
    context.PrintJson({{"steps", std::move(steps)},
                       {"obstacles", plan.obstacles},
                       {"notes", plan.notes},
                       {"untouched", plan.untouched}});
    return;
  }
  for (const PlanStep& step : plan.steps) {
    context.out() << (step.takes_away ? "! " : "  ") << Plain(ToString(step)) << '\n';
  }
  PrintSentences(plan.obstacles, context.streams().err);
  PrintSentences(plan.notes, context.streams().err);
  context.err() << "gcm: " << tendon::Counted(plan.steps.size(), "step", "steps") << ", "
                << tendon::Counted(plan.untouched, "object", "objects") << " untouched\n";
}

Result<Plan> PlanOf(Context& context, const std::string& file) {
  const auto wanted = tendon::ReadSystemFile(file);
  if (!wanted) return wanted.error();
  const auto client = context.Client();
  if (!client) return client.error();
  LearnConflictingTypes(context);
  const tendon::Catalogue catalogue = (*client)->catalogue();
  tendon::KnownClasses known;
  for (const std::string& process : ProcessesToAsk(catalogue, *wanted)) {
    const auto classes = AskClasses(context, process);
    // If the classes of the process are unknown, the process itself will refuse the step.
    if (classes) known[process] = *classes;
  }
  return MakeCheckedPlan(catalogue, *wanted, known);
}

Result<ExitCode> PrintPlan(Context& context, const std::string& file) {
  const auto plan = PlanOf(context, file);
  if (!plan) return plan.error();
  Print(*plan, context);
  return plan->obstacles.empty() ? program::kOk : program::ExitCodeOf(plan->refusal);
}

struct ApplyWords {
  std::string file;
  bool yes = false;
  bool dry_run = false;
  bool keep_going = false;
};

/// Checks whether the plan may be executed.
Result<void> CheckApply(const Plan& plan, const ApplyWords& words) {
  if (!plan.obstacles.empty() && !words.keep_going) {
    return Error{plan.refusal,
                 "nothing was done, because some steps of the plan are not possible; to do the "
                 "other steps: gcm apply " +
                     words.file + " --keep-going" + (words.yes ? " --yes" : "")};
  }
  if (plan.TakesAway() && !words.yes) {
    return Error{ErrorCode::kFailed,
                 "nothing was done, because the steps marked with ! stop, disconnect or remove "
                 "something that works; to execute these steps, too: gcm apply " +
                     words.file + " --yes" + (words.keep_going ? " --keep-going" : "")};
  }
  return {};
}

ExitCode OutcomeExitCode(const PlanOutcome& outcome, const Plan& plan) {
  const bool is_whole = !outcome.error && plan.obstacles.empty();
  if (is_whole) return program::kOk;
  if (outcome.done > 0) return program::kPartial;
  return outcome.error ? program::ExitCodeOf(outcome.error->code) : program::kRefused;
}

std::vector<tendon::message::HistoryEntry> Steps(Context& context) {
  auto history = context.Ask<tendon::message::History>(
      [](tendon::GcmClient& client, auto handler) { client.GetHistory(handler); });
  return history ? std::move(history->entries) : std::vector<tendon::message::HistoryEntry>();
}

/// Returns the id of the newest step in the history; 0 if there is none.
std::uint64_t NewestStep(Context& context) {
  const auto steps = Steps(context);
  return steps.empty() ? 0 : steps.back().id;
}

/// Returns "; to undo these steps: gcm undo 8" if there are steps after `former`. If other programs
/// have made some of these steps, returns a hint to the history instead.
std::string WayBack(Context& context, std::uint64_t former) {
  const auto steps = Steps(context);
  const auto first = std::ranges::find_if(steps, [&](const auto& one) { return one.id > former; });
  if (first == steps.end()) return "";
  const auto is_others = [&](const auto& one) { return one.who != first->who; };
  if (std::any_of(first, steps.end(), is_others)) {
    return "; other programs have made changes meanwhile; to list the changes: gcm history";
  }
  return "; to undo these steps: gcm undo " + std::to_string(steps.end() - first);
}

void Summarise(Context& context, const PlanOutcome& outcome, const Plan& plan,
               std::uint64_t former) {
  PrintSentences(plan.obstacles, context.streams().err);
  PrintSentences(plan.notes, context.streams().err);
  // A failed step may have changed the system, too.
  const bool is_changed = outcome.done + outcome.failed > 0;
  context.err() << "gcm: " << tendon::Counted(outcome.done, "step", "steps") << " done, "
                << outcome.failed << " failed, " << outcome.left << " not executed, "
                << tendon::Counted(plan.untouched, "object", "objects") << " untouched"
                << (is_changed ? WayBack(context, former) : "") << '\n';
}

/// Returns the words for the result of a step, in a table and in JSON.
Marks MarksOf(StepOutcome::State fate) {
  switch (fate) {
    case StepOutcome::State::kDone:
      return {"ok   ", "done"};
    case StepOutcome::State::kFailed:
      return {"BAD  ", "failed"};
    case StepOutcome::State::kLeft:
      return {"left ", "left"};
  }
  return {"?", "?"};
}

Result<ExitCode> Execute(Context& context, const Plan& plan, const ApplyWords& words) {
  const auto client = context.Client();
  if (!client) return client.error();
  tendon::ClientExecutor executor(**client, context.settings().timeout);
  const bool is_json = context.settings().json;
  const std::uint64_t former = is_json ? 0 : NewestStep(context);
  ordered_json steps = ordered_json::array();
  const PlanOutcome outcome = ExecutePlan(
      plan, executor, words.keep_going ? tendon::AfterError::kGoOn : tendon::AfterError::kStop,
      [&](std::size_t number, const PlanStep& step, const StepOutcome& came) {
        const auto [sign, word] = MarksOf(came.state);
        if (is_json) {
          steps.push_back(PlanStepJson(step));
          steps.back()["outcome"] = word;
          if (!came.reason.empty()) steps.back()["error"] = came.reason;
          return;
        }
        context.out() << number << '/' << plan.steps.size() << "  " << sign << Plain(ToString(step))
                      << (came.reason.empty() ? "" : ": " + Plain(came.reason)) << std::endl;
      },
      [] { return tendon::os::TerminationRequested(std::chrono::milliseconds(0)); });
  if (is_json) {
    context.PrintJson({{"steps", std::move(steps)},
                       {"obstacles", plan.obstacles},
                       {"notes", plan.notes},
                       {"done", outcome.done},
                       {"failed", outcome.failed},
                       {"left", outcome.left},
                       {"untouched", plan.untouched}});
  } else {
    Summarise(context, outcome, plan, former);
  }
  return outcome.is_interrupted ? program::kInterrupted : OutcomeExitCode(outcome, plan);
}

Result<ExitCode> Apply(Context& context, const ApplyWords& words) {
  if (words.dry_run) return PrintPlan(context, words.file);
  tendon::os::HoldTerminationSignals();  // so that a signal cannot interrupt a step
  const auto plan = PlanOf(context, words.file);
  if (!plan) return plan.error();
  if (const auto allowed = CheckApply(*plan, words); !allowed) {
    Print(*plan, context);
    return allowed.error();
  }
  return Execute(context, *plan, words);
}

}  // namespace

std::vector<Verb> SystemVerbs() {
  return {
      {"save", "save the running system in a system file",
       [](CLI::App& app) -> Verb::Run {
         auto words = std::make_shared<SaveWords>();
         WithKind(app.add_option("file", words->file, "system file to create or to update"),
                  WordKind::kFile)
             ->required();
         app.add_flag("--dry-run", words->dry_run, "print the changes, but do not write the file");
         return [words](Context& context) { return Save(context, *words); };
       }},
      {"import", "create a system file from a file of the cisst component manager",
       [](CLI::App& app) -> Verb::Run {
         auto words = std::make_shared<ImportWords>();
         WithKind(
             app.add_option(
                 "from", words->from,
                 "a file of the cisst component manager, with \"components\" and \"connections\""),
             WordKind::kFile)
             ->required();
         WithKind(app.add_option("to", words->to, "system file to create"), WordKind::kFile)
             ->required();
         app.add_option("--process", words->process,
                        "name of the process to which the components will belong")
             ->required();
         app.add_flag("--dry-run", words->dry_run, "print the changes, but do not write the file");
         return [words](Context& context) { return Import(context, *words); };
       }},
      {"diff", "list the differences between a system file and the running system, or another file",
       [](CLI::App& app) -> Verb::Run {
         auto words = std::make_shared<DiffWords>();
         WithKind(app.add_option("first", words->first, "system file"), WordKind::kFile)
             ->required();
         WithKind(app.add_option("second", words->second,
                                 "another system file (default: the running system)"),
                  WordKind::kFile);
         return [words](Context& context) { return Diff(context, *words); };
       }},
      {"plan", "list the steps that make the running system match a system file",
       [](CLI::App& app) -> Verb::Run {
         auto file = std::make_shared<std::string>();
         WithKind(app.add_option("file", *file, "system file"), WordKind::kFile)->required();
         return [file](Context& context) { return PrintPlan(context, *file); };
       }},
      {"apply", "make the running system match a system file",
       [](CLI::App& app) -> Verb::Run {
         auto words = std::make_shared<ApplyWords>();
         WithKind(app.add_option("file", words->file, "system file"), WordKind::kFile)->required();
         app.add_flag("--yes", words->yes, "also remove everything that is not in the file");
         app.add_flag("--dry-run", words->dry_run, "only list the steps, like plan");
         app.add_flag("--keep-going", words->keep_going,
                      "if a step fails, continue with all steps that do not depend on it");
         return [words](Context& context) { return Apply(context, *words); };
       }},
  };
}

}  // namespace console
