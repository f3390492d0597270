#include <tendon/gcm/client/json_field.h>

#include <tendon/base/name.h>
#include <tendon/payload/json/json_scanner.h>
#include <tendon/payload/json/strict_json.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace tendon::client {
namespace {

// These functions return parts of the text instead of parsed values, because a number that is
// parsed and printed again may have other digits.

/// Returns the key of a member and moves to the value of the member.
std::string TakeKey(JsonScanner& walk) {
  const auto key = nlohmann::json::parse(walk.Take(), nullptr, /*allow_exceptions=*/false);
  walk.ToValue();
  return key.is_string() ? key.get<std::string>() : std::string();
}

/// Returns the element of a list; empty if it does not exist. `step` is the index in the form "[3".
std::optional<std::string_view> Element(std::string_view list, std::string_view step) {
  std::size_t index = 0;
  const auto read = std::from_chars(step.data() + 1, step.data() + step.size(), index);
  const bool is_number = read.ec == std::errc() && read.ptr == step.data() + step.size();
  JsonScanner walk(list);
  if (!is_number || !walk.IsAt('[')) return std::nullopt;
  for (bool is_there = walk.Enter(); is_there; is_there = walk.Next()) {
    const std::string_view value = walk.Take();
    if (index-- == 0) return value;
  }
  return std::nullopt;
}

/// Returns the value of a key; empty if the key does not exist. Adds the keys before it, and the
/// key itself, to `keys`.
std::optional<std::string_view> Member(std::string_view object, const std::string& key,
                                       std::vector<std::string>& keys) {
  JsonScanner walk(object);
  if (!walk.IsAt('{')) return std::nullopt;
  for (bool is_there = walk.Enter(); is_there; is_there = walk.Next()) {
    keys.push_back(TakeKey(walk));
    const std::string_view value = walk.Take();
    if (keys.back() == key) return value;
  }
  return std::nullopt;
}

}  // namespace

Result<std::string> JsonField(const std::string& json, const std::string& field) {
  if (field.empty()) return json;
  if (const auto whole = ParseOrderedJson(json); !whole) return whole.error();
  std::string_view value = json;
  std::string_view rest = field;
  while (!rest.empty()) {
    std::string_view step = rest.substr(0, rest.find_first_of(".[", 1));
    rest.remove_prefix(step.size());
    const bool is_index = step.front() == '[' && step.back() == ']';
    std::vector<std::string> keys;
    const std::string key(step.substr(1));
    const auto part =
        is_index ? Element(value, step.substr(0, step.size() - 1)) : Member(value, key, keys);
    if (part) {
      value = *part;
    } else if (is_index) {
      return Error{ErrorCode::kNotFound, "there is no element " + std::string(step)};
    } else {
      return Error{ErrorCode::kNotFound, "there is no field '" + key + "'" + DidYouMean(key, keys)};
    }
  }
  return std::string(value);
}

}  // namespace tendon::client
