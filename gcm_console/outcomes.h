#pragma once

#include <gcm_console/context.h>
#include <program/exit_code.h>
#include <tendon/base/result.h>

#include <string>
#include <string_view>
#include <vector>

/// What became of each of several things that one verb was told to change.
namespace console {

struct Outcome {
  std::string path;
  tendon::Result<void> result;
};

struct Doing {
  std::string_view verb;        ///< "stop"
  std::string_view participle;  ///< "stopped"
  bool is_dry = false;          ///< it only would be
};

/// A line for each; what failed goes to the messages. One document as JSON.
void PrintOutcomes(const Context& context, const Doing& doing,
                   const std::vector<Outcome>& outcomes);

/// Of the first failure; kPartial where some went well.
[[nodiscard]] program::ExitCode ExitCodeOf(const std::vector<Outcome>& outcomes);

/// Whether who asks for a dry run could give the order as well: kDenied with --read-only, as the
/// GCM would say.
[[nodiscard]] tendon::Result<void> CheckRole(const Context& context);

/// "QUESTION? [y/N]" to a person who sits at a terminal; true where nobody does.
[[nodiscard]] bool Confirm(const Context& context, const std::string& question);

/// What is said where it was not confirmed.
[[nodiscard]] tendon::Error Declined();

}  // namespace console
