#include <tendon/payload/schema.h>
#include <tendon/payload/schema/range.h>

#include <string>

namespace tendon {
namespace {

enum class Help { kNone, kAll };

void PrintHelp(const Schema::Field& field, const std::string& indent, std::string& out) {
  if (!field.help.empty()) out += indent + "# " + field.help + "\n";
  if (field.range) out += indent + "@ " + payload::ToString(*field.range) + "\n";
}

void Print(const Schema& schema, const std::string& indent, Help help, std::string& out) {
  switch (schema.kind()) {
    case Schema::Kind::kArray:
      Print(schema.element(), indent, help, out);
      out += "[" + std::to_string(schema.length()) + "]";
      return;
    case Schema::Kind::kSequence:
      Print(schema.element(), indent, help, out);
      out += "[]";
      return;
    case Schema::Kind::kEnum:
      out += "enum " + schema.name() + " {\n";
      for (const auto& [name, value] : schema.enumerators()) {
        out += indent + "  " + name + " = " + std::to_string(value) + "\n";
      }
      out += indent + "}";
      return;
    case Schema::Kind::kStructure: {
      const std::string inner = indent + "  ";
      out += "struct " + schema.name() + " {\n";
      for (const Schema::Field& field : schema.fields()) {
        if (help == Help::kAll) PrintHelp(field, inner, out);
        out += inner + field.name + ": ";
        Print(field.schema, inner, help, out);
        if (!field.unit.empty()) out += " in " + field.unit;
        out += "\n";
      }
      out += indent + "}";
      return;
    }
    default:
      out += ToString(schema.kind());
  }
}

}  // namespace

std::string Schema::Text() const {
  std::string text;
  Print(*this, "", Help::kNone, text);
  return text;
}

std::string Schema::TextWithHelp() const {
  std::string text;
  Print(*this, "", Help::kAll, text);
  return text;
}

}  // namespace tendon
