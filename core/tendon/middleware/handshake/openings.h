#pragma once

#include <tendon/base/result.h>

#include <cstdint>
#include <functional>
#include <thread>

namespace tendon {

/// While it lives, no thread of this program opens links: openings under way end at once, new ones
/// are refused. For a program that ends while threads may be opening a link to a process that
/// hangs. Thread-safe.
class NoMoreOpening {
 public:
  NoMoreOpening() : NoMoreOpening(std::thread::id()) {}
  /// The same for one thread only; the program goes on.
  explicit NoMoreOpening(std::thread::id thread);
  NoMoreOpening(const NoMoreOpening&) = delete;
  NoMoreOpening& operator=(const NoMoreOpening&) = delete;
  ~NoMoreOpening();

 private:
  const std::thread::id thread_;  // default-constructed: all threads
};

/// While it lives, this thread counts as waiting for a link.
class WaitForLink {
 public:
  /// `give_up` must end the wait and must not block. A NoMoreOpening calls it once or more, from
  /// any thread, perhaps before the constructor returns, never after the destructor.
  explicit WaitForLink(std::function<void()> give_up);
  WaitForLink(const WaitForLink&) = delete;
  WaitForLink& operator=(const WaitForLink&) = delete;
  ~WaitForLink();

 private:
  std::uint64_t number_ = 0;
};

/// Whether a NoMoreOpening applies to this thread.
[[nodiscard]] bool IsOpeningOver();
/// The error in that case, of code kUnreachable.
[[nodiscard]] Error OpeningIsOver();

}  // namespace tendon
