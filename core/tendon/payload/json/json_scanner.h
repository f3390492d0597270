#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace tendon {

/// Walks over JSON text from value to value, and returns the text of each value exactly as it is
/// written. Never reads beyond the text, even if it is not JSON.
class JsonScanner {
 public:
  explicit JsonScanner(std::string_view text) : text_(text) { SkipBlanks(); }

  /// The present offset in the text.
  [[nodiscard]] std::size_t offset() const { return at_; }
  [[nodiscard]] bool IsAt(char letter) const { return at_ < text_.size() && text_[at_] == letter; }

  /// Enters an object or a list, up to its first key or value; returns false if it is empty.
  bool Enter() { return StepOver() && !IsAt('}') && !IsAt(']'); }
  /// Moves from a value to the next key or value; returns false after the last.
  bool Next() { return IsAt(',') && StepOver(); }
  /// Moves from a key to its value; returns false if there is no colon.
  bool ToValue() { return IsAt(':') && StepOver(); }

  /// Returns the text of a key or a value and moves past it. The text of a string includes the
  /// quotes.
  std::string_view Take() {
    const std::size_t begin = at_;
    SkipValue();
    const std::string_view taken = text_.substr(begin, at_ - begin);
    SkipBlanks();
    return taken;
  }

 private:
  bool StepOver() {
    if (at_ >= text_.size()) return false;
    ++at_;
    SkipBlanks();
    return true;
  }

  void SkipBlanks() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  void SkipString() {
    ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    at_ = std::min(at_ + 1, text_.size());
  }

  void SkipValue() {
    if (IsAt('"')) return SkipString();
    if (!IsAt('{') && !IsAt('[')) {
      at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
      return;
    }
    for (std::size_t depth = 0; at_ < text_.size();) {
      if (IsAt('"')) {
        SkipString();
        continue;
      }
      if (IsAt('{') || IsAt('[')) ++depth;
      const bool is_end = (IsAt('}') || IsAt(']')) && --depth == 0;
      ++at_;
      if (is_end) return;
    }
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace tendon
