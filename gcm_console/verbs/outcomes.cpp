#include <gcm_console/verbs/outcomes.h>

#include <gcm_console/output/table.h>
#include <tendon/base/os/terminal.h>

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

namespace console {

void PrintOutcomes(const Context& context, const VerbForms& forms,
                   const std::vector<Outcome>& outcomes) {
  if (context.settings().json) {
    auto results = nlohmann::ordered_json::array();
    for (const Outcome& one : outcomes) {
      results.push_back({{"path", one.path},
                         {"done", one.result.ok() && !forms.is_dry},
                         {"reason", one.result ? "" : one.result.error().message}});
    }
    return context.PrintJson(
        {{"verb", forms.verb}, {"dry_run", forms.is_dry}, {"results", std::move(results)}});
  }
  const std::string done = (forms.is_dry ? "would be " : "") + std::string(forms.participle);
  for (const Outcome& one : outcomes) {
    if (one.result) {
      context.out() << Plain(one.path) << '\t' << done << '\n';
    } else {
      context.streams().err << "gcm: " << Plain(one.path) << ": "
                            << Plain(one.result.error().message) << '\n';
    }
  }
}

program::ExitCode ExitCodeOf(const std::vector<Outcome>& outcomes) {
  const auto failed = [](const Outcome& one) { return !one.result; };
  const auto first = std::ranges::find_if(outcomes, failed);
  if (first == outcomes.end()) return program::kOk;
  const bool is_whole = std::ranges::all_of(outcomes, failed);
  return is_whole ? program::ExitCodeOf(first->result.error().code) : program::kPartial;
}

tendon::Result<void> CheckRole(const Context& context) {
  if (!context.settings().read_only) return {};
  return tendon::Error{tendon::ErrorCode::kDenied,
                       "gcm " + context.verb() +
                           " needs the role operator, but --read-only connects with the role "
                           "viewer: try again without --read-only"};
}

bool Confirm(const Context& context, const std::string& question) {
  using tendon::os::Stream;
  using tendon::os::TerminalColumns;
  if (!context.streams().has_input) {
    context.streams().err << "gcm: " << Plain(question) << "? If so, add --yes\n";
    return false;
  }
  if (context.columns() == 0 || TerminalColumns(Stream::kInput) == 0) return true;
  context.streams().err << Plain(question) << "? [y/N] " << std::flush;
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "y" || answer == "yes";
}

tendon::Error Declined() { return {tendon::ErrorCode::kFailed, "nothing was done"}; }

}  // namespace console
