#pragma once

#include <chrono>
#include <memory>
#include <optional>

namespace tendon::os {

/// The keys of the terminal at the standard input, each at once and unseen, as long as it lives.
/// Ctrl-C asks the process to end as ever; Ctrl-Z asks for a Pause(). For one thread, and one at a
/// time.
class Keyboard {
 public:
  Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// The next letter; nothing where none comes in time, or where there is no terminal. A change of
  /// the terminal's size, the end of a pause and the wish for one cut the time short.
  std::optional<char> NextKey(std::chrono::milliseconds patience) noexcept;

  /// Whether Ctrl-Z was pressed, or somebody else asks for a pause; once.
  [[nodiscard]] bool TakePause() noexcept;
  /// Stops the process, with the terminal as it was before, until it is told to go on.
  void Pause() noexcept;

 private:
  struct Mode;
  void Prepare() noexcept;
  void GiveBack() noexcept;
  void TakeSignals() noexcept;

  std::unique_ptr<Mode> former_;  // of the terminal; null where there is none
  bool is_pause_asked_ = false;
};

/// Whether there is something to read at the standard input, or its end; waits for at most
/// `patience`, which a signal cuts short.
[[nodiscard]] bool KeyWaits(std::chrono::milliseconds patience) noexcept;

}  // namespace tendon::os
