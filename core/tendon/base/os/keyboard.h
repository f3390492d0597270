#pragma once

#include <chrono>
#include <memory>
#include <optional>

namespace tendon::os {

/// While it lives, reads the keys of the terminal at the standard input, each at once and without
/// an echo. Ctrl-C asks the process to end, as usual; Ctrl-Z asks for a Pause(). For one thread,
/// and one object at a time.
class Keyboard {
 public:
  Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// The next letter; nothing if none comes in time or there is no terminal. A change of the
  /// terminal's size, the end of a pause and a request for one end the wait early.
  std::optional<char> NextKey(std::chrono::milliseconds patience) noexcept;

  /// True, once, if Ctrl-Z was pressed or a pause was requested in another way.
  [[nodiscard]] bool TakePause() noexcept;
  /// Stops the process, with the terminal as it was before, until it is continued.
  void Pause() noexcept;

 private:
  struct Mode;
  void Prepare() noexcept;
  void GiveBack() noexcept;
  void TakeSignals() noexcept;

  std::unique_ptr<Mode> former_;  // of the terminal; null if there is none
  bool is_pause_asked_ = false;
};

/// True if the standard input has data, or has ended. Waits for at most `patience`; a signal ends
/// the wait early.
[[nodiscard]] bool KeyWaits(std::chrono::milliseconds patience) noexcept;

}  // namespace tendon::os
