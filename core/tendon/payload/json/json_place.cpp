#include <tendon/payload/json/json_place.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace tendon {
namespace {

/// Walks over JSON text from value to value. Never reads beyond the text, even if it is not JSON.
class JsonWalk {
 public:
  explicit JsonWalk(std::string_view text) : text_(text) { SkipSpace(); }

  [[nodiscard]] std::size_t place() const { return place_; }

  /// Enters the `nth` member of that name in an object; false if there is none.
  bool EnterMember(std::string_view name, int nth) {
    if (!Take('{')) return false;
    for (SkipSpace(); Next() == '"'; SkipSpace()) {
      const std::size_t begin = at_;
      const std::string_view key = TakeString();
      SkipSpace();
      if (!Take(':')) return false;
      SkipSpace();
      if (key == name && --nth == 0) {
        place_ = begin;
        return true;
      }
      SkipValue();
      SkipSpace();
      if (!Take(',')) return false;
    }
    return false;
  }

  bool EnterElement(std::size_t index) {
    if (!Take('[')) return false;
    for (SkipSpace(); index > 0; --index, SkipSpace()) {
      SkipValue();
      SkipSpace();
      if (!Take(',')) return false;
    }
    place_ = at_;
    return true;
  }

 private:
  [[nodiscard]] char Next() const { return at_ < text_.size() ? text_[at_] : '\0'; }

  bool Take(char letter) {
    const bool is_there = Next() == letter;
    if (is_there) ++at_;
    return is_there;
  }

  void SkipSpace() { at_ = std::min(text_.find_first_not_of(" \t\r\n", at_), text_.size()); }

  /// Without its quotes, but with its escapes.
  std::string_view TakeString() {
    const std::size_t begin = ++at_;
    while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
    const std::size_t end = std::min(at_, text_.size());
    at_ = std::min(end + 1, text_.size());
    return text_.substr(begin, end - begin);
  }

  void SkipValue() {
    if (Next() == '"') {
      TakeString();
    } else if (Next() == '{' || Next() == '[') {
      SkipContainer();
    } else {
      at_ = std::min(text_.find_first_of(",]} \t\r\n", at_), text_.size());
    }
  }

  void SkipContainer() {
    int depth = 0;
    do {
      const char letter = Next();
      if (letter == '"') {
        TakeString();
        continue;
      }
      if (letter == '{' || letter == '[') ++depth;
      if (letter == '}' || letter == ']') --depth;
      ++at_;
    } while (depth > 0 && at_ < text_.size());
    at_ = std::min(at_, text_.size());
  }

  const std::string_view text_;
  std::size_t at_ = 0;
  std::size_t place_ = 0;
};

/// Takes the first part off a path: "processes", "[0]", "name". An index keeps its brackets.
std::string_view TakePart(std::string_view& path) {
  if (path.starts_with('.')) path.remove_prefix(1);
  const std::size_t end =
      path.starts_with('[') ? path.find(']') + 1 : std::min(path.find_first_of(".["), path.size());
  const std::string_view part = path.substr(0, end);
  path.remove_prefix(part.size());
  return part;
}

bool Enter(JsonWalk& walk, std::string_view part, int nth) {
  if (!part.starts_with('[')) return walk.EnterMember(part, nth);
  std::size_t index = 0;
  std::from_chars(part.data() + 1, part.data() + part.size(), index);
  return walk.EnterElement(index);
}

std::string PlaceOfNth(std::string_view text, std::string_view path, int nth) {
  JsonWalk walk(text);
  while (!path.empty()) {
    const std::string_view part = TakePart(path);
    if (part.empty() || !Enter(walk, part, path.empty() ? nth : 1)) break;
  }
  return LineAndColumn(text, walk.place());
}

}  // namespace

std::string PlaceInJson(std::string_view text, std::string_view path) {
  return PlaceOfNth(text, path, 1);
}

std::string PlaceOfSecondInJson(std::string_view text, std::string_view path) {
  return PlaceOfNth(text, path, 2);
}

std::string LineAndColumn(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t line_start = before.rfind('\n');
  const std::size_t column = line_start == before.npos ? offset + 1 : offset - line_start;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace tendon
