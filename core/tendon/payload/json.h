#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/codec.h>
#include <tendon/payload/numeric_value.h>
#include <tendon/payload/schema.h>

#include <cassert>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Converts payloads to JSON for people and scripts, and back. The functions need only a schema. A
/// structure becomes an object with its fields in order, an enum becomes the name of its value, a
/// duration becomes a number of seconds, and None becomes null. A float has the shortest form that
/// is read back as the same float, an integer has all its digits, and negative zero is -0.0.
/// Numbers that JSON does not have become "nan", "inf" and "-inf".
namespace tendon {

/// Converts a body to JSON. The error says what is wrong with the body. An enum value without a
/// name becomes a number, so that a viewer can show it.
[[nodiscard]] Result<std::string> ToJson(const Schema& schema, std::span<const std::byte> body);

/// Converts one number to JSON: a bool, an integer, a float, an enum or a duration.
[[nodiscard]] std::string ToJson(const Schema& number, const NumericValue& value);

/// Converts JSON to a body. The value must have each field exactly once, with a value in the
/// field's range. The text may have at most 16 MiB and 64 levels. The error says where the mistake
/// is, what was expected and what was found: "goal.position[3]: expected a number (rad), got string
/// 'x'".
[[nodiscard]] Result<std::vector<std::byte>> FromJson(const Schema& schema,
                                                      std::string_view json_text);

template <Payload T>
[[nodiscard]] std::string ToJson(const T& value) {
  std::vector<std::byte> body;
  Encode(value, body);
  auto json = ToJson(SchemaOf<T>(), body);
  assert(json);
  return std::move(*json);
}

template <Payload T>
[[nodiscard]] Result<T> FromJson(std::string_view json_text) {
  const auto body = FromJson(SchemaOf<T>(), json_text);
  if (!body) return body.error();
  T value{};
  if (!Decode(*body, value)) {
    return Error{ErrorCode::kInvalid, SchemaOf<T>().TypeName() + " cannot hold this value"};
  }
  return value;
}

}  // namespace tendon
