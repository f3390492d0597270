#include <tendon/base/path.h>

#include <vector>

namespace tendon {
namespace {

Error NoPath(std::string_view text, const std::string& why) {
  return Error{ErrorCode::kInvalid, "'" + std::string(text.substr(0, 200)) + "' is not a path: " +
                                        why + "; expected process/component/interface.member"};
}

}  // namespace

Result<Path> ParsePath(std::string_view text) {
  Path path;
  std::string_view rest = text;
  const auto take = [&rest](char separator) {
    const std::size_t end = rest.find(separator);
    std::string part(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return part;
  };
  path.process = take('/');
  path.component = take('/');
  const std::size_t dot = rest.find('.');
  path.interface = std::string(rest.substr(0, dot));
  if (dot != std::string_view::npos) {
    const std::string_view after = rest.substr(dot + 1);
    const std::size_t end = after.find_first_of(".[");
    path.member = std::string(after.substr(0, end));
    if (end != std::string_view::npos) path.field = std::string(after.substr(end));
    if (path.member.empty()) return NoPath(text, "nothing follows the '.'");
  }
  if (auto checked = CheckName("process", path.process); !checked) {
    return NoPath(text, checked.error().message);
  }
  const std::vector<std::pair<std::string_view, std::string*>> parts = {
      {"component", &path.component}, {"interface", &path.interface}, {"member", &path.member}};
  for (const auto& [what, part] : parts) {
    if (part->empty()) continue;
    if (auto checked = CheckName(what, *part); !checked)
      return NoPath(text, checked.error().message);
  }
  return path;
}

std::string ToString(const Path& path) {
  std::string text = path.process;
  if (!path.component.empty()) text += "/" + path.component;
  if (!path.interface.empty()) text += "/" + path.interface;
  if (!path.member.empty()) text += "." + path.member;
  return text + path.field;
}

bool MatchesGlob(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern.starts_with("**")) {
    const std::string_view rest = pattern.substr(2);
    for (std::size_t skip = 0; skip <= text.size(); ++skip) {
      if (MatchesGlob(rest, text.substr(skip))) return true;
    }
    return false;
  }
  if (pattern.front() == '*') {
    const std::string_view rest = pattern.substr(1);
    for (std::size_t skip = 0; skip <= text.size(); ++skip) {
      if (MatchesGlob(rest, text.substr(skip))) return true;
      if (skip < text.size() && (text[skip] == '/' || text[skip] == '.')) return false;
    }
    return false;
  }
  return !text.empty() && pattern.front() == text.front() &&
         MatchesGlob(pattern.substr(1), text.substr(1));
}

bool IsWithinGlob(std::string_view pattern, std::string_view path) {
  while (!MatchesGlob(pattern, path)) {
    const std::size_t end = path.find_last_of("/.");
    if (end == path.npos) return false;
    path = path.substr(0, end);
  }
  return true;
}

}  // namespace tendon
