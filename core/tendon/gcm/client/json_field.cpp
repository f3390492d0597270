#include <tendon/base/name.h>
#include <tendon/gcm/client/json_field.h>
#include <tendon/payload/json/strict_json.h>

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace tendon::client {
namespace {

/// Walks over valid JSON and keeps the text of values, because a number that is parsed and printed
/// again may have other digits.
class JsonScanner {
 public:
  explicit JsonScanner(std::string_view text) : rest_(text) { SkipBlanks(); }

  [[nodiscard]] bool IsAt(char letter) const { return !rest_.empty() && rest_.front() == letter; }

  /// Enters an object or a list, up to its first key or value; returns false if it is empty.
  bool Enter() { return StepOver() && !IsAt('}') && !IsAt(']'); }
  /// Moves from a value to the next key or value; returns false after the last.
  bool Next() { return IsAt(',') && StepOver(); }

  /// Takes the key of a member; its value comes next.
  std::string TakeKey() {
    const auto key = nlohmann::json::parse(TakeValue(), nullptr, /*allow_exceptions=*/false);
    StepOver();  // the colon
    return key.is_string() ? key.get<std::string>() : std::string();
  }

  std::string_view TakeValue() {
    const std::string_view before = rest_;
    SkipValue();
    const std::string_view value = before.substr(0, before.size() - rest_.size());
    SkipBlanks();
    return value;
  }

 private:
  bool StepOver() {
    if (rest_.empty()) return false;
    rest_.remove_prefix(1);
    SkipBlanks();
    return true;
  }

  void SkipBlanks() {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\r\n"), rest_.size()));
  }

  void SkipString() {
    std::size_t end = 1;
    while (end < rest_.size() && rest_[end] != '"') end += rest_[end] == '\\' ? 2 : 1;
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
  }

  void SkipValue() {
    if (IsAt('"')) return SkipString();
    if (!IsAt('{') && !IsAt('[')) {
      rest_.remove_prefix(std::min(rest_.find_first_of(",]} \t\r\n"), rest_.size()));
      return;
    }
    for (std::size_t depth = 0; !rest_.empty();) {
      if (IsAt('"')) {
        SkipString();
        continue;
      }
      if (IsAt('{') || IsAt('[')) ++depth;
      const bool is_end = (IsAt('}') || IsAt(']')) && --depth == 0;
      rest_.remove_prefix(1);
      if (is_end) return;
    }
  }

  std::string_view rest_;
};

/// The element with the index in "[3"; empty if there is none.
std::optional<std::string_view> Element(std::string_view list, std::string_view step) {
  std::size_t index = 0;
  const auto read = std::from_chars(step.data() + 1, step.data() + step.size(), index);
  const bool is_number = read.ec == std::errc() && read.ptr == step.data() + step.size();
  JsonScanner walk(list);
  if (!is_number || !walk.IsAt('[')) return std::nullopt;
  for (bool is_there = walk.Enter(); is_there; is_there = walk.Next()) {
    const std::string_view value = walk.TakeValue();
    if (index-- == 0) return value;
  }
  return std::nullopt;
}

/// The value of a key; empty if there is none. Collects the existing keys.
std::optional<std::string_view> Member(std::string_view object, const std::string& key,
                                       std::vector<std::string>& keys) {
  JsonScanner walk(object);
  if (!walk.IsAt('{')) return std::nullopt;
  for (bool is_there = walk.Enter(); is_there; is_there = walk.Next()) {
    keys.push_back(walk.TakeKey());
    const std::string_view value = walk.TakeValue();
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
