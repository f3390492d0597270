#include <tendon/base/name.h>
#include <tendon/gcm/client/json_field.h>
#include <tendon/payload/json/strict_json.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

namespace tendon::client {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> KeysOf(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

/// The element that "[3" names, or null.
const Json* Element(const Json& list, std::string_view step) {
  std::size_t index = 0;
  const auto read = std::from_chars(step.data() + 1, step.data() + step.size(), index);
  const bool is_number = read.ec == std::errc() && read.ptr == step.data() + step.size();
  return is_number && list.is_array() && index < list.size() ? &list[index] : nullptr;
}

}  // namespace

Result<std::string> JsonField(const std::string& json, const std::string& field) {
  if (field.empty()) return json;
  const auto whole = ParseOrderedJson(json);
  if (!whole) return whole.error();
  const Json* value = &*whole;
  std::string_view rest = field;
  while (!rest.empty()) {
    std::string_view step = rest.substr(0, rest.find_first_of(".[", 1));
    rest.remove_prefix(step.size());
    if (step.front() == '[' && step.back() == ']') {
      value = Element(*value, step.substr(0, step.size() - 1));
      if (value != nullptr) continue;
      return Error{ErrorCode::kNotFound, "there is no element " + std::string(step)};
    }
    const std::string key(step.substr(1));
    if (!value->is_object() || !value->contains(key)) {
      return Error{ErrorCode::kNotFound,
                   "there is no field '" + key + "'" + DidYouMean(key, KeysOf(*value))};
    }
    value = &(*value)[key];
  }
  return value->dump();
}

}  // namespace tendon::client
