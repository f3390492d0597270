#include <gcm_console/console.h>
#include <tendon/base/os/terminal.h>

#include <iostream>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  tendon::os::GuardStreams();
  tendon::os::IgnoreBrokenPipes();
  const std::vector<std::string> words(argv + 1, argv + argc);
  return console::RunCommandLine(words, std::cout, std::cerr,
                                 tendon::os::TerminalColumns(tendon::os::Stream::kOutput));
}
