#pragma once

#include <tendon/base/os/keyboard.h>

#include <ostream>
#include <sstream>
#include <string>

namespace console {

/// Takes over the whole screen of a terminal and restores it on destruction.
class Screen {
 public:
  explicit Screen(std::ostream& out) : out_(out) { Take(); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen() { Restore(); }

  /// Shows at most `rows` lines: as many lines of `text` as fit, and `footer` as the last one.
  void Show(const std::string& text, const std::string& footer, int rows) {
    std::istringstream lines(text);
    out_ << "\x1b[H";
    int row = 1;
    for (std::string line; row < rows && std::getline(lines, line); ++row) {
      out_ << line << "\x1b[K\r\n";
    }
    out_ << footer << "\x1b[K\x1b[J" << std::flush;
  }

  /// After Ctrl-Z: restores the screen until the process continues.
  void PauseIfAsked(tendon::os::Keyboard& keyboard) {
    if (!keyboard.TakePause()) return;
    Restore();
    keyboard.Pause();
    Take();
  }

 private:
  /// Takes the screen, and also turns line wrapping off.
  void Take() { out_ << "\x1b[?1049h\x1b[?25l\x1b[?7l" << std::flush; }
  void Restore() { out_ << "\x1b[?7h\x1b[?25h\x1b[?1049l" << std::flush; }

  std::ostream& out_;
};

}  // namespace console
