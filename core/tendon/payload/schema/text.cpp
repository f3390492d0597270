#include <tendon/payload/schema.h>

#include <string>

namespace tendon {
namespace {

void Print(const Schema& schema, const std::string& indent, std::string& out) {
  switch (schema.kind()) {
    case Schema::Kind::kArray:
      Print(schema.element(), indent, out);
      out += "[" + std::to_string(schema.length()) + "]";
      return;
    case Schema::Kind::kSequence:
      Print(schema.element(), indent, out);
      out += "[]";
      return;
    case Schema::Kind::kEnum:
      out += "enum " + schema.name() + " {\n";
      for (const auto& [name, value] : schema.enumerators()) {
        out += indent + "  " + name + " = " + std::to_string(value) + "\n";
      }
      out += indent + "}";
      return;
    case Schema::Kind::kStructure:
      out += "struct " + schema.name() + " {\n";
      for (const Schema::Field& field : schema.fields()) {
        out += indent + "  " + field.name + ": ";
        Print(field.schema, indent + "  ", out);
        if (!field.unit.empty()) out += " in " + field.unit;
        out += "\n";
      }
      out += indent + "}";
      return;
    default:
      out += ToString(schema.kind());
  }
}

}  // namespace

std::string Schema::Text() const {
  std::string text;
  Print(*this, "", text);
  return text;
}

}  // namespace tendon
