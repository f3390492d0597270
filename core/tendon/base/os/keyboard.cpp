#include <tendon/base/os/keyboard.h>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <utility>

namespace tendon::os {
namespace {

/// The pipe to which the signal handler writes the number of each terminal signal, as one byte. The
/// first Keyboard creates the pipe. It is never closed, because the handler may run at any time.
std::array<int, 2> signal_pipe = {-1, -1};

constexpr std::array<int, 3> kSignals = {SIGTSTP, SIGCONT, SIGWINCH};

void OnSignal(int signal) {
  const int error = errno;
  const char number = static_cast<char>(signal);
  // If the pipe is full, the write fails, but a full pipe wakes the reader as well.
  const auto written = write(signal_pipe[1], &number, 1);
  static_cast<void>(written);
  errno = error;
}

void HandleWith(int signal, void (*handler)(int)) noexcept {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(signal, &action, nullptr);
}

}  // namespace

struct Keyboard::Mode {
  termios settings{};
  std::array<struct sigaction, kSignals.size()> actions{};
};

Keyboard::Keyboard() {
  Mode mode;
  if (tcgetattr(STDIN_FILENO, &mode.settings) != 0) return;
  if (signal_pipe[0] < 0 && pipe2(signal_pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) return;
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals.at(i), nullptr, &mode.actions.at(i));
    if (mode.actions.at(i).sa_handler != SIG_IGN) HandleWith(kSignals.at(i), &OnSignal);
  }
  former_ = std::make_unique<Mode>(mode);
  Prepare();
}

Keyboard::~Keyboard() {
  if (!former_) return;
  Restore();
  for (std::size_t i = 0; i < kSignals.size(); ++i) {
    sigaction(kSignals.at(i), &former_->actions.at(i), nullptr);
  }
}

void Keyboard::Prepare() noexcept {
  termios settings = former_->settings;
  settings.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  settings.c_cc[VMIN] = 1;
  settings.c_cc[VTIME] = 0;
  tcsetattr(STDIN_FILENO, TCSANOW, &settings);
}

void Keyboard::Restore() noexcept { tcsetattr(STDIN_FILENO, TCSANOW, &former_->settings); }

std::optional<char> Keyboard::NextKey(std::chrono::milliseconds timeout) noexcept {
  if (!former_) return std::nullopt;
  std::array<pollfd, 2> wait = {{{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0},
                                 {.fd = signal_pipe[0], .events = POLLIN, .revents = 0}}};
  if (poll(wait.data(), wait.size(), static_cast<int>(timeout.count())) <= 0) return std::nullopt;
  if (wait[1].revents != 0) TakeSignals();
  if (wait[0].revents == 0) return std::nullopt;
  char key = 0;
  if (read(STDIN_FILENO, &key, 1) != 1) return std::nullopt;
  return key;
}

void Keyboard::TakeSignals() noexcept {
  char number = 0;
  while (read(signal_pipe[0], &number, 1) == 1) {
    if (number == SIGTSTP) is_pause_requested_ = true;
    if (number == SIGCONT) Prepare();  // another program may have changed the terminal
  }
}

bool Keyboard::TakePause() noexcept { return std::exchange(is_pause_requested_, false); }

void Keyboard::Pause() noexcept {
  if (!former_) return;
  Restore();
  HandleWith(SIGTSTP, SIG_DFL);
  raise(SIGTSTP);
  HandleWith(SIGTSTP, &OnSignal);
  Prepare();
}

bool IsKeyPressed(std::chrono::milliseconds timeout) noexcept {
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  return poll(&input, 1, static_cast<int>(timeout.count())) > 0;
}

}  // namespace tendon::os
