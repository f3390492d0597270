#include <tendon/payload/json/typed_value.h>

#include <tendon/base/text.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/number_literal.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/schema.h>

#include <nlohmann/json.hpp>

namespace tendon {
namespace {

std::string ExpectedOf(const Schema& schema, const std::string& name, const std::string& form,
                       const std::string& typed) {
  return name + ": expected " + schema.TypeName() + form + ", got " + Quoted(typed, 64);
}

Result<nlohmann::ordered_json> TypedNumber(const Schema& schema, const std::string& name,
                                           const std::string& typed) {
  const NumberLiteral word = ReadNumberLiteral(schema.kind(), typed);
  if (schema.kind() == Schema::Kind::kDuration && IsFinerThanDouble(word.json)) {
    return nlohmann::ordered_json(word.json);
  }
  if (word.flaw == NumberFlaw::kNone) return ParseOrderedJson(word.json);
  return Error{ErrorCode::kInvalid, ExpectedOf(schema, name, "", typed) + "; " + FlawText(word)};
}

/// Checks the typed text instead of the parser's result, because two mistakes are lost in the
/// result: it has only the second value of a duplicate key, and 1.00000000000000000001 becomes the
/// integer 1.
Result<void> CheckTyped(const Schema& schema, const std::string& name, const std::string& typed,
                        const nlohmann::ordered_json& value) {
  if (!FromJson(schema, value.dump())) return {};  // FromJson() reports this later, with the unit
  const auto body = FromJson(schema, typed);
  if (body) return {};
  return Error{ErrorCode::kInvalid, name + ": " + body.error().message};
}

/// Puts the exact digits from `fine` into the durations of `value`. `place` is the key of `value`
/// in `fine`.
void KeepDigits(const Schema& schema, const FineNumbers& fine, const std::string& place,
                nlohmann::ordered_json& value) {
  if (schema.kind() == Schema::Kind::kDuration && value.is_number()) {
    if (const auto digits = fine.find(place); digits != fine.end()) value = digits->second;
  } else if (schema.kind() == Schema::Kind::kStructure && value.is_object()) {
    const std::string before = place.empty() ? "" : place + ".";
    for (const Schema::Field& field : schema.fields()) {
      if (!value.contains(field.name)) continue;
      KeepDigits(field.schema, fine, before + field.name, value[field.name]);
    }
  } else if (value.is_array() &&
             (schema.kind() == Schema::Kind::kArray || schema.kind() == Schema::Kind::kSequence)) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      KeepDigits(schema.element(), fine, place + "[" + std::to_string(i) + "]", value[i]);
    }
  }
}

}  // namespace

std::string WithExactDurations(const Schema& schema, const std::string& json) {
  FineNumbers fine;
  auto value = ParseOrderedJson(json);
  if (!value || !ParseExactJson(json, &fine) || fine.empty()) return json;
  KeepDigits(schema, fine, {}, *value);
  return value->dump();
}

Result<nlohmann::ordered_json> TypedValue(const Schema& schema, const std::string& name,
                                          const std::string& typed) {
  const bool is_quoted = typed.starts_with('"');
  if (IsWrittenAsNumber(schema.kind()) && !is_quoted) return TypedNumber(schema, name, typed);
  const auto parsed = ParseOrderedJson(WithExactDurations(schema, typed));
  const bool is_word =
      schema.kind() == Schema::Kind::kString || schema.kind() == Schema::Kind::kEnum;
  const bool is_meant_as_it_is = is_word && !(parsed && parsed->is_string());
  if (!parsed && !is_meant_as_it_is) {
    return Error{ErrorCode::kInvalid,
                 ExpectedOf(schema, name, " as JSON", typed) + ": " + parsed.error().message};
  }
  nlohmann::ordered_json value = is_meant_as_it_is ? nlohmann::ordered_json(typed) : *parsed;
  try {
    (void)value.dump();
  } catch (const nlohmann::ordered_json::exception&) {
    return Error{ErrorCode::kInvalid, name + ": " + Quoted(typed, 64) + " is not valid UTF-8"};
  }
  if (!is_meant_as_it_is) {
    if (auto checked = CheckTyped(schema, name, typed, value); !checked) return checked.error();
  }
  return value;
}

}  // namespace tendon
