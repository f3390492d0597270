#pragma once

#include <tendon/base/os/keyboard.h>

#include <ostream>
#include <sstream>
#include <string>

namespace console {

/// Uses the whole screen of a terminal, and restores the screen when it is destroyed.
class Screen {
 public:
  explicit Screen(std::ostream& out) : out_(out) { Take(); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen() { Restore(); }

  /// Shows at most `rows` lines: `text`, as far as it fits, and `footer` as the last line.
  void Show(const std::string& text, const std::string& footer, int rows) {
    std::istringstream lines(text);
    out_ << "\x1b[H";
    int row = 1;
    for (std::string line; row < rows && std::getline(lines, line); ++row) {
      out_ << line << "\x1b[K\r\n";
    }
    out_ << footer << "\x1b[K\x1b[J" << std::flush;
  }

  /// If the user has pressed Ctrl-Z, restores the screen until the process continues.
  void PauseIfAsked(tendon::os::Keyboard& keyboard) {
    if (!keyboard.TakePause()) return;
    Restore();
    keyboard.Pause();
    Take();
  }

 private:
  /// Starts to use the screen, and turns line wrapping off.
  void Take() { out_ << "\x1b[?1049h\x1b[?25l\x1b[?7l" << std::flush; }
  void Restore() { out_ << "\x1b[?7h\x1b[?25h\x1b[?1049l" << std::flush; }

  std::ostream& out_;
};

}  // namespace console
