#include <tendon/base/name.h>

#include <tendon/base/text.h>

#include <algorithm>
#include <vector>

namespace tendon {
namespace {

constexpr std::size_t kMaxLength = 64;

bool IsAllowed(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '_' || letter == '-';
}

/// Escapes bytes so that they can be printed inside quotes.
std::string ToAscii(std::string_view text) {
  constexpr std::string_view kHex = "0123456789abcdef";
  std::string out;
  for (const char letter : text.substr(0, kMaxLength + 1)) {
    const auto byte = static_cast<unsigned char>(letter);
    if (byte >= 0x20 && byte < 0x7f) {
      out += letter;
    } else {
      out += "\\x";
      out += kHex[byte >> 4U];
      out += kHex[byte & 0xfU];
    }
  }
  return out;
}

/// Returns how many letters must be inserted, deleted, replaced or swapped with a neighbour to turn
/// `a` into `b` (optimal string alignment).
std::size_t EditDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before_last(b.size() + 1);
  std::vector<std::size_t> last(b.size() + 1);
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last.swap(last);
    last.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before_last[j - 2] + 1);
    }
  }
  return row[b.size()];
}

/// Returns the only candidate that begins with `beginning`; empty if there is no such candidate, or
/// more than one.
std::string OnlyOneThatBegins(std::string_view beginning, std::span<const std::string> candidates) {
  constexpr std::size_t kShortest = 2;
  std::string found;
  if (beginning.size() < kShortest) return found;
  const std::string lower = InLowerCase(beginning);
  for (const std::string& candidate : candidates) {
    const bool begins = candidate.size() > beginning.size() &&
                        InLowerCase(candidate.substr(0, beginning.size())) == lower;
    if (!begins) continue;
    if (!found.empty() && found != candidate) return {};
    found = candidate;
  }
  return found;
}

}  // namespace

Result<void> CheckName(std::string_view what, std::string_view name) {
  const std::string kind(what);
  if (name.empty()) return Error{ErrorCode::kInvalid, kind + " name is empty"};
  const auto bad = std::find_if_not(name.begin(), name.end(), IsAllowed);
  const std::string rule = "; allowed: letters digits _ - (max 64)";
  if (bad != name.end()) {
    const auto at = static_cast<std::size_t>(bad - name.begin()) + 1;
    return Error{ErrorCode::kInvalid, kind + " name '" + ToAscii(name) + "' has '" +
                                          ToAscii({&*bad, 1}) + "' at " + std::to_string(at) +
                                          rule};
  }
  if (name.size() > kMaxLength) {
    return Error{ErrorCode::kInvalid, kind + " name '" + ToAscii(name.substr(0, 20)) + "...' has " +
                                          std::to_string(name.size()) + " characters" + rule};
  }
  return {};
}

void RequireName(std::string_view what, std::string_view name) {
  if (const auto checked = CheckName(what, name); !checked) {
    throw ConfigurationError(checked.error().message);
  }
}

std::string Nearest(std::string_view name, std::span<const std::string> candidates) {
  const std::size_t limit = std::min<std::size_t>(3, std::max<std::size_t>(1, name.size() / 3));
  std::string best;
  std::size_t best_distance = limit + 1;
  const std::string lower = InLowerCase(name);
  for (const std::string& candidate : candidates) {
    const auto [shorter, longer] = std::minmax({name.size(), candidate.size()});
    if (longer - shorter > limit) continue;  // a name from the network may be megabytes long
    const std::size_t distance = EditDistance(lower, InLowerCase(candidate));
    if (2 * distance <= shorter && distance < best_distance) {
      best = candidate;
      best_distance = distance;
    }
  }
  return best.empty() ? OnlyOneThatBegins(name, candidates) : best;
}

std::string DidYouMean(std::string_view name, std::span<const std::string> candidates) {
  const std::string nearest = Nearest(name, candidates);
  return nearest.empty() ? std::string() : "; did you mean '" + nearest + "'?";
}

std::string ToString(const InterfaceName& name) {
  const std::string local = name.component + "/" + name.interface;
  return name.process.empty() ? local : name.process + "/" + local;
}

Result<InterfaceName> ParseInterfaceName(std::string_view text) {
  const std::size_t first = text.find('/');
  const std::size_t second = first == text.npos ? text.npos : text.find('/', first + 1);
  if (second == text.npos || text.find('/', second + 1) != text.npos) {
    return Error{
        ErrorCode::kInvalid,
        "'" + ToAscii(text) + "' is not an interface: expected process/component/interface"};
  }
  InterfaceName name(std::string(text.substr(0, first)),
                     std::string(text.substr(first + 1, second - first - 1)),
                     std::string(text.substr(second + 1)));
  if (auto checked = CheckName("process", name.process); !checked) return checked.error();
  if (auto checked = CheckName("component", name.component); !checked) return checked.error();
  if (auto checked = CheckName("interface", name.interface); !checked) return checked.error();
  return name;
}

}  // namespace tendon
