#include <tendon/base/os/terminal.h>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <csignal>
#include <initializer_list>

namespace tendon::os {

int TerminalColumns(Stream stream) noexcept {
  constexpr int kUsual = 80;
  const int descriptor = static_cast<int>(stream);
  if (isatty(descriptor) != 1) return 0;
  winsize size{};
  const bool says = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return says ? size.ws_col : kUsual;
}

int TerminalRows() noexcept {
  constexpr int kUsual = 24;
  winsize size{};
  const bool says = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0;
  return says ? size.ws_row : kUsual;
}

void GuardStreams() noexcept {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) != -1) continue;
    // open() returns the lowest free number, which is the number of this stream. With the opposite
    // mode (write for input, read for output), each use of the stream fails.
    static_cast<void>(open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
  }
}

void IgnoreBrokenPipes() noexcept { std::signal(SIGPIPE, SIG_IGN); }

}  // namespace tendon::os
