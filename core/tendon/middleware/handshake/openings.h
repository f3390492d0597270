#pragma once

#include <tendon/base/result.h>

#include <cstdint>
#include <functional>
#include <thread>

namespace tendon {

/// While one lives, nobody in this program waits for a link: what is being opened ends at once, and
/// what is tried meanwhile is refused. For a program that ends, whose threads may be in the middle
/// of opening a link to a process that hangs. Thread-safe.
class NoMoreOpening {
 public:
  NoMoreOpening() : NoMoreOpening(std::thread::id()) {}
  /// The same for one thread, which ends before the program does.
  explicit NoMoreOpening(std::thread::id thread);
  NoMoreOpening(const NoMoreOpening&) = delete;
  NoMoreOpening& operator=(const NoMoreOpening&) = delete;
  ~NoMoreOpening();

 private:
  const std::thread::id thread_;  // none: all
};

/// Somebody who waits for a link in this thread, while it lives.
class WaitForLink {
 public:
  /// `give_up` ends the wait: it is called once or more from any thread when nobody waits any more,
  /// maybe before this returns, and not after the destructor. Must not block.
  explicit WaitForLink(std::function<void()> give_up);
  WaitForLink(const WaitForLink&) = delete;
  WaitForLink& operator=(const WaitForLink&) = delete;
  ~WaitForLink();

 private:
  std::uint64_t number_ = 0;
};

/// Whether nobody waits for links in this thread.
[[nodiscard]] bool IsOpeningOver();
/// The refusal then, of code kUnreachable.
[[nodiscard]] Error OpeningIsOver();

}  // namespace tendon
