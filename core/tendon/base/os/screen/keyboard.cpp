#include <poll.h>
#include <sys/ioctl.h>
#include <tendon/base/os/screen/keyboard.h>
#include <termios.h>
#include <unistd.h>

namespace tendon::os {

struct Keyboard::Mode {
  termios settings{};
};

Keyboard::Keyboard() {
  Mode mode;
  if (tcgetattr(STDIN_FILENO, &mode.settings) != 0) return;
  former_ = std::make_unique<Mode>(mode);
  mode.settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  mode.settings.c_cc[VMIN] = 1;
  mode.settings.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &mode.settings);
}

Keyboard::~Keyboard() {
  if (former_) tcsetattr(STDIN_FILENO, TCSANOW, &former_->settings);
}

std::optional<char> Keyboard::NextKey(std::chrono::milliseconds patience) noexcept {
  if (!former_) return std::nullopt;
  pollfd wait{STDIN_FILENO, POLLIN, 0};
  if (poll(&wait, 1, static_cast<int>(patience.count())) <= 0) return std::nullopt;
  char key = 0;
  if (read(STDIN_FILENO, &key, 1) != 1) return std::nullopt;
  return key;
}

int TerminalRows() noexcept {
  constexpr int kUsual = 24;
  winsize size{};
  const bool says = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_row > 0;
  return says ? size.ws_row : kUsual;
}

}  // namespace tendon::os
