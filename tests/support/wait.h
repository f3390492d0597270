#pragma once

#include <chrono>
#include <thread>

#include "support/machine/sanitized.h"

/// Waits until `predicate()` is true; checks it every millisecond. Returns false after `timeout`.
template <typename Predicate>
bool EventuallyTrue(Predicate predicate,
                    std::chrono::milliseconds timeout = tendon::test::LongestWait()) {
  const auto deadline = std::chrono::steady_clock::now() + timeout;
  while (!predicate()) {
    if (std::chrono::steady_clock::now() >= deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}
