#include <gcm_console/catalogue/payload_text.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace console {
namespace {

using nlohmann::ordered_json;
using tendon::Schema;
using Kind = Schema::Kind;

std::string RangeText(const tendon::Range& range) {
  return ordered_json(range.lowest).dump() + " to " + ordered_json(range.highest).dump();
}

/// "off, on": what an enum, or a list of such, can be.
std::string NamesIn(const Schema& schema) {
  if (schema.kind() == Kind::kArray || schema.kind() == Kind::kSequence) {
    return NamesIn(schema.element());
  }
  std::string names;
  for (const auto& one : schema.enumerators()) names += (names.empty() ? "" : ", ") + one.name;
  return names;
}

void AddField(const std::string& name, const Schema::Field& field, Table& table) {
  const std::string values = field.range ? RangeText(*field.range) : NamesIn(field.schema);
  const bool is_duration = field.schema.kind() == Kind::kDuration && field.unit.empty();
  table.Add({name, field.schema.TypeName(), is_duration ? "s" : field.unit, values, field.help});
  if (field.schema.kind() != Kind::kStructure) return;
  for (const auto& inner : field.schema.fields()) AddField(name + "." + inner.name, inner, table);
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
  return nearest == 0.0 ? ordered_json(0) : ordered_json(nearest);
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
