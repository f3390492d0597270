#include <tendon/gcm/argument/common_fields.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tendon {

std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered) {
  std::vector<std::string> names;
  const auto& theirs = offered.fields();
  for (const Schema::Field& field : wanted.fields()) {
    const auto same = std::find_if(theirs.begin(), theirs.end(), [&](const Schema::Field& other) {
      return other.name == field.name && other.unit == field.unit && other.schema == field.schema;
    });
    if (same != theirs.end()) names.push_back(field.name);
  }
  return names;
}

std::string WithFieldsOf(const std::string& value, const std::string& source,
                         const std::vector<std::string>& fields) {
  using Json = nlohmann::ordered_json;
  Json mine = Json::parse(value, nullptr, false);
  const Json theirs = Json::parse(source, nullptr, false);
  if (!mine.is_object() || !theirs.is_object()) return value;
  for (const std::string& field : fields) {
    if (theirs.contains(field)) mine[field] = theirs[field];
  }
  return mine.dump();
}

}  // namespace tendon
