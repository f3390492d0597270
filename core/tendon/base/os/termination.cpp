#include <tendon/base/os/termination.h>

#include <pthread.h>
#include <tendon/base/os/terminal.h>

#include <atomic>
#include <csignal>
#include <ctime>
#include <utility>

namespace tendon::os {
namespace {

thread_local Interruption* interruption = nullptr;  // the Interruption of this thread, or null

std::atomic<bool> was_termination_requested{false};  // a signal has asked the process to terminate

sigset_t TerminationSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// Unblocks the termination signals in this thread. Returns true if they were blocked.
bool LetThrough() noexcept {
  const sigset_t signals = TerminationSignals();
  sigset_t before;
  sigemptyset(&before);
  pthread_sigmask(SIG_UNBLOCK, &signals, &before);
  return sigismember(&before, SIGTERM) == 1;
}

}  // namespace

void HoldTerminationSignals() noexcept {
  was_termination_requested.store(false, std::memory_order_relaxed);
  const sigset_t signals = TerminationSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  IgnoreBrokenPipes();
}

int WaitForTermination() noexcept {
  constexpr std::chrono::hours kLong(1);
  if (interruption != nullptr) {
    while (!interruption->Take(kLong)) {
    }
    return SIGINT;
  }
  const sigset_t signals = TerminationSignals();
  int signal = 0;
  while (sigwait(&signals, &signal) != 0) {
  }
  was_termination_requested.store(true, std::memory_order_relaxed);
  LetThrough();
  return signal;
}

bool TerminationRequested(std::chrono::milliseconds timeout) noexcept {
  if (interruption != nullptr) return interruption->Take(timeout);
  const sigset_t signals = TerminationSignals();
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(timeout);
  const timespec limit{seconds.count(), std::chrono::nanoseconds(timeout - seconds).count()};
  if (sigtimedwait(&signals, nullptr, &limit) <= 0) return false;
  was_termination_requested.store(true, std::memory_order_relaxed);
  LetThrough();
  return true;
}

bool WasTerminationRequested() noexcept {
  if (was_termination_requested.load(std::memory_order_relaxed)) return true;
  sigset_t pending;
  sigemptyset(&pending);
  sigpending(&pending);
  return sigismember(&pending, SIGINT) == 1 || sigismember(&pending, SIGTERM) == 1;
}

void ForgetInterrupt() noexcept {
  if (interruption != nullptr) return interruption->Forget();
  sigset_t interrupt;
  sigemptyset(&interrupt);
  sigaddset(&interrupt, SIGINT);
  const timespec now{};
  while (sigtimedwait(&interrupt, nullptr, &now) > 0) {
  }
}

TerminationUnblockScope::TerminationUnblockScope() noexcept
    : was_held_(interruption == nullptr && LetThrough()) {}

TerminationUnblockScope::~TerminationUnblockScope() {
  if (was_held_) HoldTerminationSignals();
}

Interruption::Interruption() noexcept { interruption = this; }

Interruption::~Interruption() { interruption = nullptr; }

void Interruption::Request() noexcept {
  const std::scoped_lock lock(mutex_);
  is_requested_ = true;
  change_.notify_all();
}

bool Interruption::Take(std::chrono::milliseconds timeout) noexcept {
  std::unique_lock lock(mutex_);
  change_.wait_for(lock, timeout, [this] { return is_requested_; });
  return std::exchange(is_requested_, false);
}

void Interruption::Forget() noexcept {
  const std::scoped_lock lock(mutex_);
  is_requested_ = false;
}

}  // namespace tendon::os
