#pragma once

#include <chrono>
#include <thread>

/// Waits until `predicate()` holds, looking every millisecond; false when it does not within
/// `timeout`, which is long: it bounds a test that fails, and says nothing about speed.
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
