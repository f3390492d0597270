#include <gcm_console/shell/command_parser.h>

#include <cctype>
#include <utility>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

bool IsBlank(char letter) { return std::isspace(static_cast<unsigned char>(letter)) != 0; }

/// Removes `gcm` before a verb. A line that was copied from a terminal begins with `gcm`.
void PassOverName(Words& words) {
  while (words.size() > 1 && words.front() == "gcm") words.erase(words.begin());
}

bool EndsCommand(char letter) { return letter == ';' || letter == '&'; }

class Reader {
 public:
  explicit Reader(std::string_view line) : line_(line) {}

  Result<void> Read() {
    while (true) {
      for (; !at_end() && IsBlank(next()); ++place_) is_open_ = false;
      if (at_end() || next() == '#') return {};
      if (EndsCommand(next())) {
        is_open_ = false;
        EndCommand(line_[place_++] == '&');
        continue;
      }
      begin_ = place_;
      is_open_ = true;
      if (auto word = ReadWord(); !word) return word;
    }
  }
  void EndCommand(bool is_background) {
    PassOverName(words_);
    if (!words_.empty()) commands_.push_back({std::exchange(words_, {}), is_background});
  }

  [[nodiscard]] std::vector<ShellCommand>& commands() { return commands_; }
  [[nodiscard]] Words& words() { return words_; }
  /// Returns the start of the last word; if the line ends with a blank, the end of the line.
  [[nodiscard]] std::size_t begin() const { return is_open_ ? begin_ : line_.size(); }
  /// Returns the part of the last word that was read so far.
  [[nodiscard]] const std::string& rest() const { return word_; }

 private:
  [[nodiscard]] bool at_end() const { return place_ >= line_.size(); }
  [[nodiscard]] char next() const { return line_[place_]; }
  char Take() {
    word_ += line_[place_];
    return line_[place_++];
  }

  Result<void> ReadWord() {
    word_.clear();
    const bool is_json = next() == '{' || next() == '[';
    if (auto read = is_json ? ReadJson() : ReadPlain(); !read) return read;
    words_.push_back(std::exchange(word_, ""));
    return {};
  }
  Result<void> ReadPlain() {
    while (!at_end() && !IsBlank(next()) && !EndsCommand(next())) {
      if (next() == '\\' && place_ + 1 < line_.size()) {
        ++place_;
        Take();
      } else if (next() == '\'' || next() == '"') {
        if (auto read = ReadQuoted(next()); !read) return read;
      } else if (Take() == '=' && !at_end() && (next() == '{' || next() == '[')) {
        if (auto read = ReadJson(); !read) return read;
      }
    }
    return {};
  }
  Result<void> ReadQuoted(char quote) {
    const std::size_t begin = place_++;
    while (!at_end() && next() != quote) {
      if (quote == '"' && next() == '\\' && place_ + 1 < line_.size()) ++place_;
      Take();
    }
    if (at_end()) return NoEnd("quote", begin);
    ++place_;
    return {};
  }
  Result<void> ReadJson() {
    const std::size_t begin = place_;
    int depth = 0;
    bool is_in_string = false;
    while (!at_end()) {
      const char letter = Take();
      if (is_in_string) {
        if (letter == '\\' && !at_end()) Take();
        if (letter == '"') is_in_string = false;
        continue;
      }
      if (letter == '"') is_in_string = true;
      if (letter == '{' || letter == '[') ++depth;
      if ((letter == '}' || letter == ']') && --depth == 0) return {};
    }
    return NoEnd("bracket", begin);
  }
  [[nodiscard]] Error NoEnd(const std::string& what, std::size_t begin) const {
    return {ErrorCode::kInvalid,
            "the " + what + " in column " + std::to_string(begin + 1) + " is not closed"};
  }

  std::string_view line_;
  std::size_t place_ = 0;
  std::size_t begin_ = 0;
  bool is_open_ = false;  // the last word may continue
  std::string word_;
  Words words_;
  std::vector<ShellCommand> commands_;
};

}  // namespace

Result<std::vector<ShellCommand>> ParseCommands(std::string_view line) {
  Reader reader(line);
  if (auto read = reader.Read(); !read) return read.error();
  reader.EndCommand(false);
  return std::move(reader.commands());
}

std::string QuoteWord(std::string_view word) {
  std::string typed;
  for (const char letter : word) {
    const bool begins = typed.empty() && (letter == '#' || letter == '{' || letter == '[');
    const bool is_special =
        EndsCommand(letter) || letter == '\'' || letter == '"' || letter == '\\' || IsBlank(letter);
    if (begins || is_special) typed += '\\';
    typed += letter;
  }
  return typed;
}

PartialCommand ParsePartialCommand(std::string_view line) {
  Reader reader(line);
  const bool is_whole = static_cast<bool>(reader.Read());
  PartialCommand partial{std::move(reader.words()), std::string(line.substr(reader.begin()))};
  if (!is_whole) {
    partial.words.push_back(reader.rest());
  } else if (partial.typed.empty()) {
    partial.words.emplace_back();
  }
  PassOverName(partial.words);
  return partial;
}

}  // namespace console
