#pragma once

#include <chrono>
#include <thread>

/// Waits until `predicate()` is true; checks it every millisecond. Returns false after `timeout`.
/// The default is long: it only limits a failing test, and is not a requirement on speed.
template <typename Predicate>
bool EventuallyTrue(Predicate predicate,
                    std::chrono::milliseconds timeout = std::chrono::seconds(30)) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (!predicate()) {
    if (std::chrono::steady_clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}
