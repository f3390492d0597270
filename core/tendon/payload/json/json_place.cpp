#include <tendon/payload/json/json_place.h>

#include <tendon/payload/json/json_scanner.h>

#include <algorithm>
#include <charconv>
#include <cstddef>

namespace tendon {
namespace {

/// Removes the first part from a path and returns it: "processes", "[0]", "name". An index keeps
/// its brackets.
std::string_view TakePart(std::string_view& path) {
  if (path.starts_with('.')) path.remove_prefix(1);
  const std::size_t end =
      path.starts_with('[') ? path.find(']') + 1 : std::min(path.find_first_of(".["), path.size());
  const std::string_view part = path.substr(0, end);
  path.remove_prefix(part.size());
  return part;
}

/// Enters the `nth` member with this name in an object, and sets `place` to the offset of its key.
/// Returns false if there is no such member.
bool EnterMember(JsonScanner& walk, std::string_view name, int nth, std::size_t& place) {
  if (!walk.IsAt('{')) return false;
  for (bool is_there = walk.Enter(); is_there && walk.IsAt('"'); is_there = walk.Next()) {
    const std::size_t begin = walk.offset();
    std::string_view key = walk.Take();
    if (!walk.ToValue()) return false;
    key = key.substr(1, key.size() - 2);  // removes the quotes
    if (key == name && --nth == 0) {
      place = begin;
      return true;
    }
    walk.Take();
  }
  return false;
}

bool EnterElement(JsonScanner& walk, std::size_t index, std::size_t& place) {
  if (!walk.IsAt('[')) return false;
  for (walk.Enter(); index > 0; --index) {
    walk.Take();
    if (!walk.Next()) return false;
  }
  place = walk.offset();
  return true;
}

bool Enter(JsonScanner& walk, std::string_view part, int nth, std::size_t& place) {
  if (!part.starts_with('[')) return EnterMember(walk, part, nth, place);
  std::size_t index = 0;
  std::from_chars(part.data() + 1, part.data() + part.size(), index);
  return EnterElement(walk, index, place);
}

std::string PlaceOfNth(std::string_view text, std::string_view path, int nth) {
  JsonScanner walk(text);
  std::size_t place = 0;
  while (!path.empty()) {
    const std::string_view part = TakePart(path);
    if (part.empty() || !Enter(walk, part, path.empty() ? nth : 1, place)) break;
  }
  return LineAndColumn(text, place);
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
