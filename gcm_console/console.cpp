#include <gcm_console/console.h>

#include <gcm_console/command_line/command_line.h>
#include <gcm_console/command_line/help_text.h>
#include <gcm_console/completion/path_completion.h>
#include <gcm_console/completion/shell_completion.h>
#include <gcm_console/output/table.h>
#include <tendon/base/text.h>

#include <cerrno>
#include <exception>
#include <ostream>

namespace console {
namespace {

/// Returns true if everything was written. Otherwise errno contains the cause, even if an earlier
/// write has failed.
bool IsWritten(std::ostream& out) {
  if (!out.good()) {
    out.clear();
    out << '\n';
    out.flush();
    return false;
  }
  return static_cast<bool>(out.flush());
}

/// Returns the exit code of a verb. If the verb has failed, prints the reason.
int Finish(const tendon::Result<program::ExitCode>& result, const Streams& streams) {
  const bool is_written = IsWritten(streams.out);
  // True if the reader has closed the pipe, as `head` does after ten lines.
  const bool is_left = errno == EPIPE;
  const bool is_interrupted = errno == EINTR;  // by a signal, while the reader was slow
  if (!result) {
    streams.err << "gcm: " << tendon::Printable(result.error().message) << '\n';
    return program::ExitCodeOf(result.error().code);
  }
  if (!is_written && is_interrupted) return program::kInterrupted;
  if (!is_written && *result != program::kInterrupted) {
    if (!is_left)
      streams.err << "gcm: cannot write the output: the disk is full, or the output is closed\n";
    return program::kRefused;
  }
  return *result;
}

/// Returns a function that completes abbreviated paths and prints the complete paths, for a user at
/// a prompt. Returns null for a script, because a script must use full paths.
CommandLine::Complement ComplementOf(const Streams& streams, ShellSession* session) {
  const bool is_typed =
      session != nullptr && streams.make_line_reader != nullptr && session->settings().scripts == 0;
  if (!is_typed) return nullptr;
  return [&streams, session](WordKind kind, const std::string& typed) {
    const tendon::Catalogue catalogue = session->catalogue();
    const std::string at = session->settings().at;
    const std::string path = PathFrom(catalogue, at, typed);
    std::string whole = WholePath(catalogue, kind, path);
    if (whole != ResolvedPath(at, typed)) {
      streams.err << "gcm: " << Plain(typed) << " is " << (at.empty() ? "" : "/") << Plain(whole)
                  << '\n';
    }
    return whole;
  };
}

int Run(const std::vector<std::string>& words, const Streams& streams, const Settings& usual,
        ShellSession* session) {
  if (!words.empty() && words[0] == kCompleteVerb) return PrintCompletions(words, streams);
  CommandLine line(usual, ComplementOf(streams, session));
  try {
    if (const auto parsed = line.Parse(words); !parsed) return Finish(parsed.error(), streams);
  } catch (const CLI::CallForVersion&) {
    streams.out << VersionLine() << '\n';
    return Finish(program::kOk, streams);
  } catch (const CLI::Success&) {
    streams.out << HelpText(line.chosen_page(), streams.columns);
    return Finish(program::kOk, streams);
  }
  try {
    Context context(line.settings(), line.verb(), streams, session);
    return Finish(line.run()(context), streams);
  } catch (const std::exception& failure) {  // memory or file descriptors are exhausted
    streams.err << "gcm: " << Plain(failure.what()) << '\n';
    return program::kRefused;
  }
}

}  // namespace

int RunCommandLine(const std::vector<std::string>& words, std::ostream& out, std::ostream& err,
                   int columns) {
  return RunCommandLine(words, {out, err, columns});
}

int RunCommandLine(const std::vector<std::string>& words, const Streams& streams) {
  return Run(words, streams, {}, nullptr);
}

int RunCommandLine(const std::vector<std::string>& words, const Streams& streams,
                   ShellSession& session) {
  return Run(words, streams, session.settings(), &session);
}

}  // namespace console
