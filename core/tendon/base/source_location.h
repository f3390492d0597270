#pragma once

#include <string>
#include <string_view>

namespace tendon {

/// A line of source code. If current() is a default argument, it returns the caller's line.
/// Replaces std::source_location, which clang has only since version 15.
class SourceLocation {
 public:
  [[nodiscard]] static constexpr SourceLocation current(const char* file = __builtin_FILE(),
                                                        unsigned line = __builtin_LINE()) noexcept {
    return {file, line};
  }

  [[nodiscard]] constexpr std::string_view file_name() const noexcept { return file_; }
  [[nodiscard]] constexpr unsigned line() const noexcept { return line_; }

 private:
  constexpr SourceLocation(const char* file, unsigned line) noexcept : file_(file), line_(line) {}

  const char* file_;
  unsigned line_;
};

/// Returns the file name and the line: "arm.cpp:23".
[[nodiscard]] inline std::string ToString(const SourceLocation& location) {
  const std::string_view path = location.file_name();
  return std::string(path.substr(path.rfind('/') + 1)) + ":" + std::to_string(location.line());
}

}  // namespace tendon
