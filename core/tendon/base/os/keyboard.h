#pragma once

#include <chrono>
#include <memory>
#include <optional>

namespace tendon::os {

/// Reads single keys of the terminal at the standard input, without echo, while this object exists.
/// Ctrl-C asks the process to end, as usual. Ctrl-Z only requests a pause, which TakePause()
/// reports. One thread uses the object; only one object may exist at a time.
class Keyboard {
 public:
  Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// Waits for the next key and returns its letter. Returns nothing if no key is pressed within
  /// `timeout` or there is no terminal. A change of the terminal's size, a request to pause and
  /// the end of a pause end the wait early.
  std::optional<char> NextKey(std::chrono::milliseconds timeout) noexcept;

  /// Returns true, once, after Ctrl-Z was pressed or a pause was requested in another way.
  [[nodiscard]] bool TakePause() noexcept;
  /// Restores the terminal and stops the process until it is continued.
  void Pause() noexcept;

 private:
  struct Mode;
  void Prepare() noexcept;
  void Restore() noexcept;
  void TakeSignals() noexcept;

  std::unique_ptr<Mode> former_;  // the terminal's former mode; null if there is no terminal
  bool is_pause_requested_ = false;
};

/// True if the standard input has data, or has ended. Waits for at most `timeout`; a signal ends
/// the wait early.
[[nodiscard]] bool IsKeyPressed(std::chrono::milliseconds timeout) noexcept;

}  // namespace tendon::os
