#include <gcm_console/completion/completer.h>
#include <gcm_console/completion/whole_path.h>
#include <gcm_console/line/command_line.h>
#include <gcm_console/place.h>

#include <algorithm>
#include <set>

namespace console {
namespace {

constexpr const char* kSeparators = "/.";

/// The only name below `way` that equals `begin` or begins with it; empty if none or several do.
std::string NameBehind(const tendon::Catalogue& catalogue, WordKind kind, const std::string& way,
                       const std::string& begin) {
  std::set<std::string> names;
  for (const std::string& path : PathsOf(catalogue, kind, way + begin)) {
    const std::string rest = path.substr(way.size());
    names.insert(rest.substr(0, rest.find_first_of(kSeparators)));
  }
  if (names.contains(begin)) return begin;
  return names.size() == 1 && !begin.empty() ? *names.begin() : "";
}

}  // namespace

std::string WholePath(const tendon::Catalogue& catalogue, WordKind kind, const std::string& path) {
  std::string whole;
  std::size_t begin = 0;
  while (begin < path.size()) {
    const bool is_member = whole.ends_with('.');
    const std::size_t end =
        std::min(path.find_first_of(is_member ? ".[" : kSeparators, begin), path.size());
    const std::string name = NameBehind(catalogue, kind, whole, path.substr(begin, end - begin));
    if (name.empty()) return path;
    whole += name;
    if (is_member || end == path.size())
      return whole + path.substr(end);  // fields are not completed
    whole += path[end];
    begin = end + 1;
  }
  return path;
}

std::string PathFrom(const tendon::Catalogue& catalogue, const std::string& at,
                     const std::string& typed) {
  const std::string first = typed.substr(0, typed.find_first_of(kSeparators));
  const std::string below = ResolvedPath(at, first);
  const bool is_below = at.empty() || first == typed ||
                        FindPlace(catalogue, WholePath(catalogue, WordKind::kPath, below));
  const std::string process = WholePath(catalogue, WordKind::kProcess, first);
  return ResolvedPath(is_below || catalogue.FindProcess(process) == nullptr ? at : "", typed);
}

}  // namespace console
