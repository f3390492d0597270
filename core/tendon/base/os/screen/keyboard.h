#pragma once

#include <chrono>
#include <memory>
#include <optional>

namespace tendon::os {

/// The keys of the terminal at the standard input, each at once and unseen, as long as it lives.
/// Ctrl-C asks the process to end as ever. For one thread, and one at a time.
class Keyboard {
 public:
  Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// The next letter; nothing where none comes in time, or where there is no terminal.
  std::optional<char> NextKey(std::chrono::milliseconds patience) noexcept;

 private:
  struct Mode;
  std::unique_ptr<Mode> former_;  // of the terminal; null where there is none
};

/// How many lines the terminal at the standard output has, 24 where it does not say.
[[nodiscard]] int TerminalRows() noexcept;

}  // namespace tendon::os
