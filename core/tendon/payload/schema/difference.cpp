#include <tendon/payload/schema.h>

#include <algorithm>

namespace tendon {
namespace {

std::string Differ(const std::string& where, const std::string& needed,
                   const std::string& offered) {
  return (where.empty() ? "" : where + ": ") + needed + " needed, " + offered + " offered";
}

/// True if two types are equal, apart from their fields and elements.
bool SameShell(const Schema& needed, const Schema& offered) {
  return needed.kind() == offered.kind() && needed.name() == offered.name() &&
         needed.length() == offered.length();
}

std::optional<std::string> EnumDifference(const Schema& needed, const Schema& offered) {
  const auto print = [](const Schema& schema, std::size_t index) {
    if (index >= schema.enumerators().size()) return std::string("no further value");
    const auto& [name, value] = schema.enumerators()[index];
    return name + " = " + std::to_string(value);
  };
  const std::size_t count = std::max(needed.enumerators().size(), offered.enumerators().size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::string want = print(needed, i);
    const std::string have = print(offered, i);
    if (want != have) return Differ(needed.name(), want, have);
  }
  return std::nullopt;
}

std::string WithUnit(const Schema::Field& field) {
  return field.schema.TypeName() + (field.unit.empty() ? " without unit" : " in " + field.unit);
}

/// Returns the first difference. `where` is the name of the compared values for the message:
/// "position of arm.JointState".
std::optional<std::string> Difference(const Schema& needed, const Schema& offered,
                                      const std::string& where);

std::optional<std::string> FieldDifference(const Schema& structure, const Schema::Field& needed,
                                           const Schema::Field& offered) {
  const std::string where = needed.name + " of " + structure.name();
  if (needed.unit != offered.unit) return Differ(where, WithUnit(needed), WithUnit(offered));
  return Difference(needed.schema, offered.schema, where);
}

std::optional<std::string> StructureDifference(const Schema& needed, const Schema& offered) {
  const auto print = [](const Schema& schema, std::size_t index) {
    return index < schema.fields().size() ? "field " + schema.fields()[index].name
                                          : std::string("no further field");
  };
  const std::size_t count = std::max(needed.fields().size(), offered.fields().size());
  for (std::size_t i = 0; i < count; ++i) {
    const std::string want = print(needed, i);
    const std::string have = print(offered, i);
    if (want != have) return Differ(needed.name(), want, have);
    if (auto found = FieldDifference(needed, needed.fields()[i], offered.fields()[i])) return found;
  }
  return std::nullopt;
}

std::optional<std::string> Difference(const Schema& needed, const Schema& offered,
                                      const std::string& where) {
  if (!SameShell(needed, offered)) return Differ(where, needed.TypeName(), offered.TypeName());
  switch (needed.kind()) {
    case Schema::Kind::kEnum:
      return EnumDifference(needed, offered);
    case Schema::Kind::kStructure:
      return StructureDifference(needed, offered);
    case Schema::Kind::kArray:
    case Schema::Kind::kSequence:
      // Names the whole types, for example float64[3][4] and float64[3][5], because this is easier
      // to read than the innermost difference.
      if (needed.TypeName() != offered.TypeName()) {
        return Differ(where, needed.TypeName(), offered.TypeName());
      }
      return Difference(needed.element(), offered.element(), where);
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<std::string> FirstDifference(const Schema& needed, const Schema& offered) {
  return Difference(needed, offered, "");
}

}  // namespace tendon
