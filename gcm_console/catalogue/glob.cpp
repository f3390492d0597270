#include <gcm_console/catalogue/glob.h>

#include <tendon/base/path.h>

#include <set>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;

/// Returns true if `path` is one of `paths`, or is below one of them.
bool IsIn(const std::set<std::string>& paths, std::string path) {
  while (!paths.contains(path)) {
    const std::size_t end = path.find_last_of("/.");
    if (end == path.npos) return false;
    path.resize(end);
  }
  return true;
}

}  // namespace

bool IsGlob(const std::string& path) { return path.find('*') != path.npos; }

Result<std::vector<SystemItem>> MatchingItems(const tendon::Catalogue& catalogue,
                                              const std::string& glob) {
  auto items = ItemsIn(catalogue);
  std::erase_if(items, [&](const SystemItem& one) { return !tendon::MatchesGlob(glob, one.path); });
  if (!items.empty()) return items;
  return Error{ErrorCode::kNotFound,
               "nothing matches '" + glob + "'; to list all names: gcm ls -R"};
}

Result<std::vector<SystemItem>> MatchingItemsAndContents(const tendon::Catalogue& catalogue,
                                                         const std::string& glob) {
  const auto fitting = MatchingItems(catalogue, glob);
  if (!fitting) return fitting;
  std::set<std::string> paths;
  for (const SystemItem& one : *fitting) paths.insert(one.path);
  auto items = ItemsIn(catalogue);
  std::erase_if(items, [&](const SystemItem& one) { return !IsIn(paths, one.path); });
  return items;
}

Error NoGlobAllowed(const std::string& command, const std::string& glob) {
  return {ErrorCode::kInvalid, "'" + glob + "' may match several objects, but " + command +
                                   " needs exactly one name; to list the matches: gcm find '" +
                                   glob + "'"};
}

}  // namespace console
