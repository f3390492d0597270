#pragma once

#include <gcm_console/context.h>
#include <program/exit_code.h>
#include <tendon/base/result.h>

#include <string>
#include <string_view>
#include <vector>

/// The results of a verb that changes several things.
namespace console {

struct Outcome {
  std::string path;
  tendon::Result<void> result;
};

struct VerbForms {
  std::string_view verb;        ///< "stop"
  std::string_view participle;  ///< "stopped"
  bool is_dry = false;          ///< a dry run: nothing is changed
};

/// Prints one line per thing to the output, and failures to the messages; with JSON, one document.
void PrintOutcomes(const Context& context, const VerbForms& forms,
                   const std::vector<Outcome>& outcomes);

/// The exit code of the first failure; kPartial if some things succeeded.
[[nodiscard]] program::ExitCode ExitCodeOf(const std::vector<Outcome>& outcomes);

/// Checks that the real run would be allowed too: kDenied with --read-only, as the GCM would
/// answer.
[[nodiscard]] tendon::Result<void> CheckRole(const Context& context);

/// Asks "QUESTION? [y/N]" at a terminal. True without a terminal; false in a window.
[[nodiscard]] bool Confirm(const Context& context, const std::string& question);

/// The error after the user has said no.
[[nodiscard]] tendon::Error Declined();

}  // namespace console
