#include <tendon/payload/schema/values_text.h>

#include <tendon/payload/schema/range.h>

namespace tendon {
namespace {

/// Returns the possible values of an enum, or of a list of enums.
std::string NamesIn(const Schema& schema) {
  if (schema.kind() == Schema::Kind::kArray || schema.kind() == Schema::Kind::kSequence) {
    return NamesIn(schema.element());
  }
  std::string names;
  for (const auto& one : schema.enumerators()) names += (names.empty() ? "" : ", ") + one.name;
  return names;
}

}  // namespace

std::string ValuesText(const Schema::Field& field) {
  return field.range ? payload::ToString(*field.range) : NamesIn(field.schema);
}

}  // namespace tendon
