#include <tendon/payload/schema/ros_parser.h>

#include <tendon/base/text.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <utility>

namespace tendon {
namespace {

constexpr std::size_t kMaxRosText = std::size_t{1} << 20;  // as Schema::Parse()
constexpr std::size_t kMaxRosLevels = 64;                  // likewise
constexpr std::size_t kMaxInMessage = 100;                 // bytes of a text in a message
constexpr std::string_view kSpaces = " \t\r";

std::string_view WithoutSpaces(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kSpaces);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpaces) + 1 - begin);
}

/// "geometry_msgs/Point" for "geometry_msgs/msg/Point".
std::string ShortName(std::string_view name) {
  std::string text(name);
  const std::size_t middle = text.find("/msg/");
  return middle == text.npos ? text : text.replace(middle, 5, "/");
}

std::string_view PackageOf(std::string_view name) { return name.substr(0, name.find('/')); }

/// The kind of a built-in type of ROS 2.
std::optional<Schema::Kind> BuiltinKind(std::string_view type) {
  static const std::map<std::string_view, Schema::Kind> kKinds{
      {"bool", Schema::Kind::kBool},
      {"byte", Schema::Kind::kUint8},
      {"char", Schema::Kind::kUint8},
      {"int8", Schema::Kind::kInt8},
      {"uint8", Schema::Kind::kUint8},
      {"int16", Schema::Kind::kInt16},
      {"uint16", Schema::Kind::kUint16},
      {"int32", Schema::Kind::kInt32},
      {"uint32", Schema::Kind::kUint32},
      {"int64", Schema::Kind::kInt64},
      {"uint64", Schema::Kind::kUint64},
      {"float32", Schema::Kind::kFloat32},
      {"float64", Schema::Kind::kFloat64},
      {"string", Schema::Kind::kString},
      {"time", Schema::Kind::kDuration},
      {"duration", Schema::Kind::kDuration},
      {"builtin_interfaces/Time", Schema::Kind::kDuration},
      {"builtin_interfaces/Duration", Schema::Kind::kDuration}};
  const auto found = kKinds.find(type);
  if (found == kKinds.end()) return std::nullopt;
  return found->second;
}

/// Stops at the first mistake.
class RosParser {
 public:
  RosParser(std::string_view name, std::string_view text) : root_(ShortName(name)) {
    std::string name_of_section = root_;
    std::size_t begin = 0;  // of the section
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      const std::string_view line = WithoutSpaces(text.substr(at, end - at));
      if (line.starts_with("===")) {
        Add(name_of_section, text.substr(begin, at - begin));
        name_of_section.clear();
        begin = end;
      } else if (name_of_section.empty() && line.starts_with("MSG:")) {
        name_of_section = ShortName(WithoutSpaces(line.substr(4)));
        begin = end;
      }
      at = end + 1;
    }
    Add(name_of_section, text.substr(std::min(begin, text.size())));
  }

  Result<Schema> Parse() {
    const auto root = Message(root_, 0);
    if (!root) return root.error();
    return Schema::Parse(root->schema.Text());  // checks names and limits
  }

 private:
  /// A message, and the approximate size of its canonical text.
  struct ParsedType {
    Schema schema;
    std::size_t size = 0;
  };

  void Add(const std::string& name, std::string_view text) {
    if (!name.empty()) definitions_.try_emplace(name, text);
  }

  Result<ParsedType> Message(const std::string& name, std::size_t level) {
    if (const auto known = parsed_.find(name); known != parsed_.end()) return known->second;
    const auto definition = definitions_.find(name);
    if (definition == definitions_.end()) return Mistake(name, "the definition is missing");
    if (level == kMaxRosLevels) return Mistake(name, "more than 64 levels");
    if (!open_.insert(name).second) return Mistake(name, "the message contains itself");
    std::vector<Schema::Field> fields;
    std::size_t size = 0;
    for (std::size_t at = 0; at < definition->second.size();) {
      const std::size_t end =
          std::min(definition->second.find('\n', at), definition->second.size());
      const std::string_view line = WithoutSpaces(definition->second.substr(at, end - at));
      at = end + 1;
      if (line.empty() || line.front() == '#') continue;
      if (auto read = Field(name, line, level, fields, size); !read) return read.error();
      if (size > kMaxRosText) return Mistake(name, "the type has more than 1 MiB of text");
    }
    open_.erase(name);
    std::string type_name = name;
    std::replace(type_name.begin(), type_name.end(), '/', '.');
    return parsed_
        .emplace(name, ParsedType{Schema::Structure(std::move(type_name), std::move(fields)), size})
        .first->second;
  }

  /// Reads a line such as "float64[<=3] position [1, 2] # in m". Skips constants, because they are
  /// not sent.
  Result<void> Field(const std::string& owner, std::string_view line, std::size_t level,
                     std::vector<Schema::Field>& fields, std::size_t& size) {
    const std::size_t type_end = line.find_first_of(kSpaces);
    if (type_end == line.npos) return Mistake(owner, Quoted(line, kMaxInMessage) + " is no field");
    const std::string_view type = line.substr(0, type_end);
    const std::string_view rest = WithoutSpaces(line.substr(type_end));
    const std::string_view name = rest.substr(0, rest.find_first_of(" \t=#"));
    const std::string_view after = WithoutSpaces(rest.substr(name.size()));
    if (after.starts_with('=')) return {};
    auto parsed = Type(owner, type, level);
    if (!parsed) return parsed.error();
    constexpr std::size_t kLine = 32;  // bytes, besides the name
    size += name.size() + kLine + parsed->size;
    fields.push_back({std::string(name), "", std::move(parsed->schema)});
    return {};
  }

  Result<ParsedType> Type(const std::string& owner, std::string_view type, std::size_t level) {
    const std::size_t bracket = type.find('[');
    auto element = Item(owner, type.substr(0, bracket), level);
    if (!element || bracket == type.npos) return element;
    std::string_view length = type.substr(bracket + 1);
    if (!length.ends_with(']')) return Mistake(owner, Quoted(type, kMaxInMessage) + " is no type");
    length.remove_suffix(1);
    const bool is_bounded = length.starts_with("<=");
    if (length.empty() || is_bounded) {
      return ParsedType{Schema::Sequence(std::move(element->schema)), element->size};
    }
    std::uint32_t count = 0;
    const auto [end, code] = std::from_chars(length.begin(), length.end(), count);
    if (code != std::errc{} || end != length.end()) {
      return Mistake(owner, Quoted(type, kMaxInMessage) + " is no type");
    }
    return ParsedType{Schema::Array(std::move(element->schema), count), element->size};
  }

  Result<ParsedType> Item(const std::string& owner, std::string_view type, std::size_t level) {
    const std::string name = ShortName(type.substr(0, type.find("<=")));
    if (const auto kind = BuiltinKind(name)) return ParsedType{Schema(*kind), 0};
    if (name == "wstring") {
      return Mistake(owner, "wstring is not read, because its encoding differs between programs");
    }
    const std::string found = Resolve(owner, name);
    if (!found.empty()) return Message(found, level + 1);
    return Mistake(owner, "the definition of " + Quoted(name, kMaxInMessage) + " is missing");
  }

  /// A name without a package means the message in the same package or, if there is none, the only
  /// message with this name.
  [[nodiscard]] std::string Resolve(const std::string& owner, const std::string& name) const {
    if (definitions_.contains(name)) return name;
    if (name.find('/') != name.npos) return "";
    const std::string sibling = std::string(PackageOf(owner)) + "/" + name;
    if (definitions_.contains(sibling)) return sibling;
    std::string only;
    for (const auto& [other, text] : definitions_) {
      if (!other.ends_with("/" + name)) continue;
      if (!only.empty()) return "";
      only = other;
    }
    return only;
  }

  static Error Mistake(const std::string& message, const std::string& what) {
    return {ErrorCode::kInvalid, "message " + Quoted(message, kMaxInMessage) + ": " + what};
  }

  const std::string root_;
  std::map<std::string, std::string_view> definitions_;  // by short name
  std::map<std::string, ParsedType> parsed_;
  std::set<std::string> open_;  // the messages that are being read
};

}  // namespace

Result<Schema> ParseRosMessage(std::string_view name, std::string_view text) {
  if (text.size() > kMaxRosText) {
    return Error{ErrorCode::kInvalid, "the message definition has " + std::to_string(text.size()) +
                                          " bytes of text; at most 1048576 are read"};
  }
  return RosParser(name, text).Parse();
}

}  // namespace tendon
