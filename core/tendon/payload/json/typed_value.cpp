#include <tendon/base/printable.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/json/typed_value.h>
#include <tendon/payload/schema.h>

#include <nlohmann/json.hpp>

namespace tendon {

Result<nlohmann::ordered_json> TypedValue(const Schema& schema, const std::string& name,
                                          const std::string& typed) {
  const auto parsed = ParseOrderedJson(typed);
  const bool is_word =
      schema.kind() == Schema::Kind::kString || schema.kind() == Schema::Kind::kEnum;
  const bool is_meant_as_it_is = is_word && !(parsed && parsed->is_string());
  if (!parsed && !is_meant_as_it_is) {
    return Error{ErrorCode::kInvalid, name + ": expected " + schema.TypeName() + " as JSON, got '" +
                                          Printable(typed, 64) + "': " + parsed.error().message};
  }
  nlohmann::ordered_json value = is_meant_as_it_is ? nlohmann::ordered_json(typed) : *parsed;
  try {
    (void)value.dump();
  } catch (const nlohmann::ordered_json::exception&) {
    return Error{ErrorCode::kInvalid, name + ": '" + Printable(typed, 64) + "' is no UTF-8"};
  }
  return value;
}

}  // namespace tendon
