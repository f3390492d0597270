#include <tendon/payload/schema.h>
#include <tendon/payload/schema/range.h>

#include <algorithm>
#include <set>

namespace tendon {
namespace {

constexpr std::string_view kDuration = "builtin_interfaces/Duration";

/// Returns the name that a message text has for a structure: "arm/JointState" for "arm.JointState".
std::string MessageName(const Schema& structure) {
  std::string name = structure.name();
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos) return "tendon/" + name;
  std::replace(name.begin(), name.end(), '.', '_');
  name[dot] = '/';
  return name;
}

char Upper(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

std::string Upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) { return Upper(c); });
  return text;
}

/// "goal_points" becomes "GoalPoints".
std::string CamelCase(const std::string& name) {
  std::string out;
  bool first = true;
  for (const char c : name) {
    if (c != '_') out += first ? Upper(c) : c;
    first = c == '_';
  }
  return out;
}

/// Prints a message definition, and then each definition that it needs, once.
class MessagePrinter {
 public:
  std::string Print(const Schema& root) {
    if (root.kind() == Schema::Kind::kStructure) {
      printed_.insert(MessageName(root));
      return Body(root) + appendix_;
    }
    return Line({"data", "", root}, "tendon/Value") + appendix_;
  }

 private:
  std::string Body(const Schema& structure) {
    std::string out;
    for (const Schema::Field& field : structure.fields()) {
      out += Line(field, MessageName(structure));
    }
    return out;
  }

  std::string Line(const Schema::Field& field, const std::string& owner) {
    std::string out = field.help.empty() ? "" : "# " + field.help + "\n";
    out += Constants(field) + Type(field.schema, owner + CamelCase(field.name)) + " " + field.name;
    std::string comment = field.unit;
    if (field.range) comment += (comment.empty() ? "" : ", ") + payload::ToString(*field.range);
    return out + (comment.empty() ? "" : "  # " + comment) + "\n";
  }

  /// Returns a line such as "int32 MODE_OFF=0" for each value of an enum.
  static std::string Constants(const Schema::Field& field) {
    const Schema* innermost = &field.schema;
    while (innermost->kind() == Schema::Kind::kArray ||
           innermost->kind() == Schema::Kind::kSequence) {
      innermost = &innermost->element();
    }
    std::string out;
    for (const auto& [name, value] : innermost->enumerators()) {
      out += "int32 " + Upper(field.name) + "_" + Upper(name) + "=" + std::to_string(value) + "\n";
    }
    return out;
  }

  /// Returns the ROS type of a field. ROS has no lists of lists, so nested arrays become one longer
  /// array. Any other inner list becomes a separate message `wrapper`, which has the same bytes on
  /// the wire.
  std::string Type(const Schema& schema, const std::string& wrapper) {
    switch (schema.kind()) {
      case Schema::Kind::kArray: {
        const Schema* element = &schema;
        std::uint64_t length = 1;
        for (; element->kind() == Schema::Kind::kArray; element = &element->element()) {
          length *= element->length();
        }
        return Item(*element, wrapper) + "[" + std::to_string(length) + "]";
      }
      case Schema::Kind::kSequence:
        return Item(schema.element(), wrapper) + "[]";
      default:
        return Item(schema, wrapper);
    }
  }

  std::string Item(const Schema& schema, const std::string& wrapper) {
    switch (schema.kind()) {
      case Schema::Kind::kArray:
      case Schema::Kind::kSequence:
        Append(wrapper, [&] { return Line({"data", "", schema}, wrapper); });
        return wrapper;
      case Schema::Kind::kStructure:
        Append(MessageName(schema), [&] { return Body(schema); });
        return MessageName(schema);
      case Schema::Kind::kDuration:
        Append(std::string(kDuration), [] { return "int32 sec\nuint32 nanosec\n"; });
        return std::string(kDuration);
      case Schema::Kind::kEnum:
        return "int32";
      default:
        return std::string(ToString(schema.kind()));
    }
  }

  template <typename MakeBody>
  void Append(const std::string& name, MakeBody make_body) {
    if (!printed_.insert(name).second) return;
    const std::string body = make_body();
    appendix_ += std::string(80, '=') + "\nMSG: " + name + "\n" + body;
  }

  std::set<std::string> printed_;
  std::string appendix_;
};

}  // namespace

std::string RosMessage(const Schema& schema) { return MessagePrinter().Print(schema); }

std::string RosTypeName(const Schema& schema) {
  const bool structure = schema.kind() == Schema::Kind::kStructure;
  std::string name = structure ? MessageName(schema) : "tendon/Value";
  return name.insert(name.find('/'), "/msg");
}

}  // namespace tendon
