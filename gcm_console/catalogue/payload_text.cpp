#include <gcm_console/catalogue/payload_text.h>

#include <tendon/payload/schema/values_text.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>

namespace console {
namespace {

using nlohmann::ordered_json;
using tendon::Schema;
using Kind = Schema::Kind;

void AddField(const std::string& name, const Schema::Field& field, Table& table) {
  const bool is_duration = field.schema.kind() == Kind::kDuration && field.unit.empty();
  table.Add({name, field.schema.TypeName(), is_duration ? "s" : field.unit, ValuesText(field),
             field.help});
  if (field.schema.kind() != Kind::kStructure) return;
  for (const auto& inner : field.schema.fields()) AddField(name + "." + inner.name, inner, table);
}

/// Returns a number for an integer field, which accepts neither a fraction nor an exponent.
ordered_json WholeNumber(double nearest) {
  constexpr double kEnd = 0x1p63;
  const double whole = nearest > 0.0 ? std::ceil(nearest) : std::floor(nearest);
  if (whole >= -kEnd && whole < kEnd) return static_cast<std::int64_t>(whole);
  return whole > 0.0 && whole < 2.0 * kEnd ? ordered_json(static_cast<std::uint64_t>(whole))
                                           : ordered_json(0);
}

ordered_json ValueOf(const Schema& schema, const std::optional<tendon::Range>& range) {
  switch (schema.kind()) {
    case Kind::kBool:
      return false;
    case Kind::kString:
      return "";
    case Kind::kEnum:
      return schema.enumerators().empty() ? ordered_json(0)
                                          : ordered_json(schema.enumerators().front().name);
    case Kind::kArray: {
      ordered_json all = ordered_json::array();
      for (std::uint32_t i = 0; i < schema.length(); ++i) {
        all.push_back(ValueOf(schema.element(), range));
      }
      return all;
    }
    case Kind::kSequence:
      return ordered_json::array();
    case Kind::kStructure: {
      if (schema.is_none()) return nullptr;
      ordered_json all = ordered_json::object();
      for (const auto& field : schema.fields()) {
        all[field.name] = ValueOf(field.schema, field.range);
      }
      return all;
    }
    default:
      break;
  }
  const double nearest = range ? std::clamp(0.0, range->lowest, range->highest) : 0.0;
  const bool is_integer = schema.is_number() && schema.kind() < Kind::kFloat32;
  if (nearest == 0.0 || is_integer) return WholeNumber(nearest);
  return nearest;
}

}  // namespace

Table FieldsOf(const Schema& schema) {
  Table table({"FIELD", "TYPE", "UNIT", "VALUES", "HELP"});
  if (schema.kind() != Kind::kStructure) {
    AddField("-", {.name = "", .unit = "", .schema = schema}, table);
  }
  for (const auto& field : schema.fields()) AddField(field.name, field, table);
  return table;
}

std::string JsonSkeleton(const Schema& schema) { return ValueOf(schema, std::nullopt).dump(); }

}  // namespace console
