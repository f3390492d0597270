#include <gcm_console/output/table.h>
#include <gcm_console/verbs/outcomes.h>
#include <gcm_console/verbs/verb.h>
#include <program/command_line.h>
#include <tendon/gcm/lifecycle/undo_check.h>
#include <tendon/gcm/step_history.h>
#include <tendon/gcm/text.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <vector>

namespace console {
namespace {

using nlohmann::ordered_json;
using program::ExitCode;
using tendon::Error;
using tendon::Result;
using tendon::message::HistoryEntry;

ordered_json StepJson(const HistoryEntry& step) {
  ordered_json json = {{"id", step.id}, {"verb", step.verb}};
  if (step.lifecycle.process.empty()) {
    json["required"] = ToString(step.ends.required);
    json["provided"] = ToString(step.ends.provided);
  } else if (step.lifecycle.component.empty()) {
    json["process"] = step.lifecycle.process;
  } else {
    json["component"] = step.lifecycle.process + "/" + step.lifecycle.component;
  }
  if (step.verb == "replace") json["former"] = ToString(step.former);
  if (const std::string changes = tendon::ChangesText(step); !changes.empty()) {
    json["changes"] = changes;
  }
  json.update({{"who", step.who},
               {"when", step.when},
               {"unknown", step.is_unknown},
               {"undone", step.undone},
               {"passed_over", step.passed_over}});
  return json;
}

/// Returns the step with its changes: "configure robot/arm: noise 0.001 -> 0.5".
std::string WhatOf(const HistoryEntry& step) {
  const std::string changes = tendon::ChangesText(step);
  return tendon::ToString(step) + (changes.empty() ? "" : ": " + changes);
}

struct UndoWords {
  int count = 1;
  std::uint64_t step = 0;
  bool skip = false;
  bool dry_run = false;
};

/// The result of undoing several steps.
struct UndoResult {
  std::vector<HistoryEntry> steps;
  std::vector<HistoryEntry> passed_over;
  std::optional<Error> error;  ///< the error that has ended the undo
};

Result<HistoryEntry> AskForUndo(Context& context, std::uint64_t step) {
  return context.Ask<HistoryEntry>(
      [step](tendon::GcmClient& client, auto handler) { client.Undo(handler, step); },
      tendon::GcmClient::kUndoTimeouts);
}

/// Undoes one step. If the undo fails and the user allows it, skips the step. If the step cannot be
/// skipped, returns the error of the undo.
Result<HistoryEntry> UndoOne(Context& context, const UndoWords& words, UndoResult& undone) {
  auto step = AskForUndo(context, words.step);
  const bool may_pass = words.skip && undone.passed_over.empty();
  if (step || !may_pass || step.error().code != tendon::ErrorCode::kFailed) return step;
  auto passed = context.Ask<HistoryEntry>([&words](tendon::GcmClient& client, auto handler) {
    client.SkipNewestStep(handler, words.step);
  });
  if (!passed) return step;
  undone.passed_over.push_back(*std::move(passed));
  return AskForUndo(context, words.step);
}

void Print(Context& context, const UndoResult& undone, bool is_dry) {
  if (context.settings().json) {
    ordered_json steps = ordered_json::array();
    for (const auto& step : undone.steps) steps.push_back(StepJson(step));
    ordered_json passed_over = ordered_json::array();
    for (const auto& step : undone.passed_over) passed_over.push_back(StepJson(step));
    context.PrintJson({{"undone", std::move(steps)},
                       {"passed_over", std::move(passed_over)},
                       {"dry_run", is_dry}});
    return;
  }
  for (const auto& step : undone.passed_over) {
    context.err() << (is_dry ? "gcm: would be skipped and not undone: "
                             : "gcm: skipped and not undone: ")
                  << Plain(tendon::WholeText(step)) << '\n';
  }
  for (const auto& step : undone.steps) {
    const std::string now =
        step.verb == "replace" ? "; it is connected to " + ToString(step.former) : "";
    context.out() << (is_dry ? "would be undone: " : "undone: ") << Plain(WhatOf(step) + now)
                  << '\n';
  }
}

/// Returns true if the process may return with its state. In this case, the step must not be
/// skipped.
bool MayComeBack(const tendon::Catalogue& catalogue, const HistoryEntry& step) {
  const auto* owner = catalogue.FindProcess(tendon::ProcessOf(step));
  return owner != nullptr && owner->process.state == tendon::ProcessState::kLost &&
         owner->process.instance == step.instance;
}

Result<tendon::message::History> AskForHistory(Context& context) {
  return context.Ask<tendon::message::History>(
      [](tendon::GcmClient& client, auto handler) { client.GetHistory(handler); });
}

/// Checks whether the newest step can be undone or skipped. Older steps cannot be checked: they
/// depend on the result of the newest step.
Result<void> CheckNewest(const tendon::Catalogue& catalogue,
                         const tendon::message::History& history, const UndoWords& words,
                         UndoResult& undone) {
  const Error nothing{ErrorCode::kFailed, "there is nothing to undo"};
  if (undone.steps.empty()) return nothing;
  const HistoryEntry newest = undone.steps.front();
  if (words.step != 0 && newest.id != words.step) {
    return Error{ErrorCode::kFailed, "step " + std::to_string(words.step) +
                                         " is not the newest step any more; the newest step is " +
                                         tendon::WholeText(newest) + "; see: gcm history"};
  }
  auto checked = CheckUndoOf(catalogue, history, newest);
  if (checked || !words.skip || MayComeBack(catalogue, newest)) return checked;
  undone.passed_over.push_back(newest);
  undone.steps.erase(undone.steps.begin());
  return undone.steps.empty() ? nothing : CheckUndoOf(catalogue, history, undone.steps.front());
}

Result<ExitCode> SayWhatWouldBeUndone(Context& context, const UndoWords& words) {
  if (auto allowed = CheckRole(context); !allowed) return allowed.error();
  const auto history = AskForHistory(context);
  if (!history) return history.error();
  const auto client = context.Client();
  if (!client) return client.error();
  UndoResult undone;
  for (auto step = history->entries.rbegin(); step != history->entries.rend(); ++step) {
    if (!step->undone && !step->passed_over) undone.steps.push_back(*step);
  }
  const auto checked = CheckNewest((*client)->catalogue(), *history, words, undone);
  if (!checked && undone.passed_over.empty()) return checked.error();
  const auto count = checked ? static_cast<std::size_t>(words.count) : 0;
  if (undone.steps.size() > count) undone.steps.resize(count);
  Print(context, undone, words.dry_run);
  if (checked) return program::kOk;
  return checked.error();
}

Result<ExitCode> Undo(Context& context, const UndoWords& words) {
  if (words.dry_run) return SayWhatWouldBeUndone(context, words);
  UndoResult undone;
  while (!undone.error && undone.steps.size() < static_cast<std::size_t>(words.count)) {
    auto step = UndoOne(context, words, undone);
    if (step) {
      undone.steps.push_back(*std::move(step));
    } else {
      undone.error = step.error();
    }
  }
  if (undone.steps.empty() && undone.passed_over.empty()) return *undone.error;
  Print(context, undone, words.dry_run);
  if (!undone.error) return program::kOk;
  context.streams().err << "gcm: " << Plain(undone.error->message) << '\n';
  return undone.steps.empty() ? program::ExitCodeOf(undone.error->code) : program::kPartial;
}

Result<ExitCode> History(Context& context, std::size_t count) {
  const auto history = AskForHistory(context);
  if (!history) return history.error();
  const auto& all = history->entries;
  const std::vector<HistoryEntry> newest(
      all.end() - static_cast<std::ptrdiff_t>(std::min(count, all.size())), all.end());
  if (context.settings().json) {
    ordered_json steps = ordered_json::array();
    for (const auto& step : newest) steps.push_back(StepJson(step));
    context.PrintJson({{"steps", std::move(steps)}});
    return program::kOk;
  }
  Table table({"STEP", "WHEN", "WHO", "STATE", "WHAT"});
  for (const auto& step : newest) {
    const std::string state = step.undone        ? "undone"
                              : step.passed_over ? "skipped"
                              : step.is_unknown  ? "unknown"
                                                 : "done";
    table.Add(
        {std::to_string(step.id), tendon::WallTimeText(step.when), step.who, state, WhatOf(step)});
  }
  context.Print(table);
  return program::kOk;
}

}  // namespace

std::vector<Verb> HistoryVerbs() {
  return {
      {"undo", "undo the last changes of the system",
       [](CLI::App& app) -> Verb::Run {
         auto words = std::make_shared<UndoWords>();
         auto* const count = app.add_option("count", words->count, "number of changes to undo")
                                 ->transform(CLI::Validator(&program::TransformCount, ""))
                                 ->check(CLI::Range(1, 1000))
                                 ->capture_default_str();
         app.add_option("--step", words->step,
                        "undo only the step with this number, if it is still the newest step; to "
                        "list the numbers: gcm history")
             ->transform(CLI::Validator(&program::TransformCount, ""))
             ->excludes(count);
         app.add_flag("--skip", words->skip,
                      "if the newest step cannot be undone now, skip this step permanently")
             ->excludes(count);
         app.add_flag("--dry-run", words->dry_run,
                      "only print what would be undone, and whether the first step can be undone");
         return [words](Context& context) { return Undo(context, *words); };
       }},
      {"history", "list the changes of the system: what was changed, by whom and when",
       [](CLI::App& app) -> Verb::Run {
         auto count = std::make_shared<std::size_t>(50);
         app.add_option("--count", *count, "number of changes to list, the newest first")
             ->transform(CLI::Validator(&program::TransformCount, ""))
             ->capture_default_str();
         return [count](Context& context) { return History(context, *count); };
       }},
  };
}

}  // namespace console
