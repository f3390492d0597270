#include <pthread.h>
#include <tendon/base/os/terminal.h>
#include <tendon/base/os/termination.h>

#include <csignal>
#include <ctime>

namespace tendon::os {
namespace {

sigset_t TerminationSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// Whether they were held.
bool LetThrough() noexcept {
  const sigset_t signals = TerminationSignals();
  sigset_t before;
  sigemptyset(&before);
  pthread_sigmask(SIG_UNBLOCK, &signals, &before);
  return sigismember(&before, SIGTERM) == 1;
}

}  // namespace

void HoldTerminationSignals() noexcept {
  const sigset_t signals = TerminationSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  IgnoreBrokenPipes();
}

int WaitForTermination() noexcept {
  const sigset_t signals = TerminationSignals();
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) {
  }
  LetThrough();
  return signal;
}

bool TerminationAsked(std::chrono::milliseconds patience) noexcept {
  const sigset_t signals = TerminationSignals();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(patience);
  const timespec limit{seconds.count(), std::chrono::nanoseconds(patience - seconds).count()};
  if (sigtimedwait(&signals, nullptr, &limit) <= 0) return false;
  LetThrough();
  return true;
}

void ForgetInterrupt() noexcept {
  sigset_t interrupt;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  const timespec now{};
  while (sigtimedwait(&interrupt, nullptr, &now) > 0) {
  }
}

TerminationLetThrough::TerminationLetThrough() noexcept : was_held_(LetThrough()) {}

TerminationLetThrough::~TerminationLetThrough() {
  if (was_held_) HoldTerminationSignals();
}

}  // namespace tendon::os
