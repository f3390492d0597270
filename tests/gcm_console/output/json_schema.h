#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

/// Returns why a value does not match a JSON schema, with the position in the value; empty if the
/// value matches. Supports the keywords that Tendon's schemas use: anyOf, type, const, enum,
/// required, properties, additionalProperties: false and items.
inline std::string MisfitOf(const nlohmann::json& value, const nlohmann::json& schema,
                            const std::string& place = "document") {
  using nlohmann::json;
  if (schema.contains("const") && value != schema["const"]) return place + " is " + value.dump();
  if (schema.contains("enum")) {
    const auto& all = schema["enum"];
    if (std::find(all.begin(), all.end(), value) == all.end()) return place + " is " + value.dump();
  }
  if (schema.contains("anyOf")) {
    std::string misfits;
    for (const auto& one : schema["anyOf"]) {
      const std::string misfit = MisfitOf(value, one, place);
      if (misfit.empty()) return "";
      misfits += (misfits.empty() ? "" : "; or ") + misfit;
    }
    return misfits;
  }
  if (schema.contains("type")) {
    const std::string type = schema["type"];
    const bool fits =
        (type == "string" && value.is_string()) || (type == "number" && value.is_number()) ||
        (type == "integer" && value.is_number_integer()) ||
        (type == "boolean" && value.is_boolean()) || (type == "array" && value.is_array()) ||
        (type == "object" && value.is_object());
    if (!fits) return place + " is no " + type + ": " + value.dump();
  }
  for (const auto& key : schema.value("required", json::array())) {
    if (!value.contains(key)) return place + " lacks " + key.get<std::string>();
  }
  const json properties = schema.value("properties", json::object());
  if (value.is_object()) {
    for (const auto& [key, part] : value.items()) {
      const bool is_known = properties.contains(key);
      if (!is_known && !schema.value("additionalProperties", true)) {
        return place + " has " + key + ", which no reader knows";
      }
      if (!is_known) continue;
      const std::string misfit = MisfitOf(part, properties[key], place + "." + key);
      if (!misfit.empty()) return misfit;
    }
  }
  if (value.is_array() && schema.contains("items")) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      const std::string misfit =
          MisfitOf(value[i], schema["items"], place + "[" + std::to_string(i) + "]");
      if (!misfit.empty()) return misfit;
    }
  }
  return "";
}
