#include <tendon/gcm/common_fields.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace tendon {
namespace {

bool MayBeLarge(const Schema& schema) {
  constexpr std::size_t kSmall = 4096;
  using Kind = Schema::Kind;
  if (schema.kind() == Kind::kSequence || schema.kind() == Kind::kString) return true;
  if (schema.kind() == Kind::kArray && MayBeLarge(schema.element())) return true;
  const auto& fields = schema.fields();
  return schema.minimum_size() > kSmall ||
         std::any_of(fields.begin(), fields.end(),
                     [](const Schema::Field& field) { return MayBeLarge(field.schema); });
}

}  // namespace

std::vector<std::string> CommonFields(const Schema& wanted, const Schema& offered) {
  std::vector<std::string> names;
  if (MayBeLarge(offered)) return names;
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
  auto mine = nlohmann::ordered_json::parse(value, nullptr, false);
  const auto theirs = nlohmann::ordered_json::parse(source, nullptr, false);
  if (!mine.is_object() || !theirs.is_object()) return value;
  for (const std::string& field : fields) {
    if (theirs.contains(field)) mine[field] = theirs[field];
  }
  return mine.dump();
}

}  // namespace tendon
