#pragma once

#include <gcm_console/context.h>
#include <program/exit_code.h>
#include <tendon/base/result.h>

#include <string>
#include <string_view>
#include <vector>

/// The results of a verb that changes several objects.
namespace console {

struct Outcome {
  std::string path;
  tendon::Result<void> result;
};

struct VerbForms {
  std::string_view verb;        ///< "stop"
  std::string_view participle;  ///< "stopped"
  bool is_dry = false;          ///< true for a dry run, in which nothing is changed
};

/// Prints one line per object to the output, and failures as messages. With --json, prints one
/// document.
void PrintOutcomes(const Context& context, const VerbForms& forms,
                   const std::vector<Outcome>& outcomes);

/// Returns the exit code of the first failure. Returns kPartial if some changes failed and others
/// succeeded.
[[nodiscard]] program::ExitCode ExitCodeOf(const std::vector<Outcome>& outcomes);

/// For a dry run: checks whether the user may execute the verb. Returns kDenied with --read-only,
/// as the GCM would.
[[nodiscard]] tendon::Result<void> CheckRole(const Context& context);

/// Asks "QUESTION? [y/N]" at a terminal. If there is no terminal, returns true; in a window,
/// returns false.
[[nodiscard]] bool Confirm(const Context& context, const std::string& question);

/// Returns the error to report after the user has answered no.
[[nodiscard]] tendon::Error Declined();

}  // namespace console
