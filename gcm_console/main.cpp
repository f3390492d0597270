#include <gcm_console/console.h>
#include <gcm_console/shell/line_editor.h>
#include <tendon/base/os/output_buffer.h>
#include <tendon/base/os/terminal.h>

#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  using tendon::os::Stream;
  tendon::os::GuardStreams();
  tendon::os::IgnoreBrokenPipes();
  const std::vector<std::string> words(argv + 1, argv + argc);
  const int columns = tendon::os::TerminalColumns(Stream::kOutput);
  const bool is_typed = columns > 0 && tendon::os::TerminalColumns(Stream::kInput) > 0;
  tendon::os::OutputBuffer output(static_cast<int>(Stream::kOutput));
  tendon::os::OutputBuffer errors(static_cast<int>(Stream::kError));
  std::streambuf* const usual_output = std::cout.rdbuf(&output);
  std::streambuf* const usual_errors = std::cerr.rdbuf(&errors);
  const int exit_code = console::RunCommandLine(
      words, {std::cout, std::cerr, columns, is_typed ? &console::MakeLineEditor : nullptr});
  std::cout.rdbuf(usual_output);
  std::cerr.rdbuf(usual_errors);
  return exit_code;
}
