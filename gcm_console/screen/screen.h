#pragma once

#include <tendon/base/os/screen/keyboard.h>

#include <cstdio>
#include <ostream>
#include <sstream>
#include <string>

namespace console {

/// Takes the whole screen of a terminal as long as it lives, and gives it back as it was.
class Screen {
 public:
  explicit Screen(std::ostream& out) : out_(out) { Take(); }
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen() { GiveBack(); }

  /// Lines that do not fit into so many rows are left out, but for the last of them, `footer`,
  /// which is always there.
  void Show(const std::string& text, const std::string& footer, int rows) {
    std::istringstream lines(text);
    out_ << "\x1b[H";
    int row = 1;
    for (std::string line; row < rows && std::getline(lines, line); ++row) {
      out_ << line << "\x1b[K\r\n";
    }
    out_ << footer << "\x1b[K\x1b[J" << std::flush;
  }

  /// Once Ctrl-Z was pressed: gives the screen back until the process goes on.
  void PauseIfAsked(tendon::os::Keyboard& keyboard) {
    if (!keyboard.TakePause()) return;
    GiveBack();
    keyboard.Pause();
    Take();
  }

 private:
  /// A line that is too long ends at the edge.
  void Take() { out_ << "\x1b[?1049h\x1b[?25l\x1b[?7l" << std::flush; }
  void GiveBack() { out_ << "\x1b[?7h\x1b[?25h\x1b[?1049l" << std::flush; }

  std::ostream& out_;
};

/// With so many digits behind the point.
inline std::string Fixed(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", digits, value);
  return text;
}

/// As a scale says it: with four digits that matter.
inline std::string Short(double value) {
  char text[64];
  std::snprintf(text, sizeof(text), "%.4g", value);
  return text;
}

}  // namespace console
