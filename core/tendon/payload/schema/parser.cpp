#include <tendon/payload/schema.h>
#include <tendon/payload/schema/range.h>

#include <algorithm>
#include <charconv>
#include <unordered_set>

namespace tendon {
namespace {

constexpr std::size_t kMaxText = std::size_t{1} << 20;
constexpr std::size_t kMaxValue = std::size_t{1} << 31;  // bytes
constexpr int kMaxLevels = 64;

/// A schema and its number of levels.
struct ParsedType {
  Schema schema;
  int height = 1;
};

/// A recursive-descent parser; stops at the first mistake.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Result<Schema> Parse() {
    ParsedType parsed = ParseType(1);
    SkipSpace();
    if (!failed() && position_ < text_.size()) Fail("expected the end");
    if (failed()) return *error_;
    return std::move(parsed.schema);
  }

 private:
  ParsedType ParseType(int depth) {
    if (depth > kMaxLevels) return Fail("more than 64 levels");
    const std::string_view word = Word();
    ParsedType parsed;
    if (word == "struct") {
      parsed = ParseStructure(depth);
    } else if (word == "enum") {
      parsed = ParseEnum();
    } else if (const auto kind = SimpleKind(word)) {
      parsed.schema = Schema(*kind);
    } else {
      position_ -= word.size();
      return Fail("expected a type");
    }
    while (!failed() && Accept('[')) parsed = ParseSuffix(std::move(parsed), depth);
    return parsed;
  }

  /// Reads the text after '[': the length of an array, or no length for a sequence.
  ParsedType ParseSuffix(ParsedType element, int depth) {
    const int height = element.height + 1;
    if (depth + height > kMaxLevels + 1) return Fail("more than 64 levels");
    if (Accept(']')) return {Schema::Sequence(std::move(element.schema)), height};
    const auto length = Number<std::uint32_t>();
    if (failed() || !Expect(']')) return {};
    if (length == 0) return Fail("an array has at least one element");
    if (length > kMaxValue / element.schema.minimum_size())
      return Fail("a value of this type would exceed 2 GiB");
    return {Schema::Array(std::move(element.schema), length), height};
  }

  ParsedType ParseStructure(int depth) {
    std::string name = TypeName();
    std::vector<Schema::Field> fields;
    std::unordered_set<std::string_view> names;
    int height = 0;
    std::size_t size = 0;
    Expect('{');
    while (!failed() && !Accept('}')) {
      const std::string_view help = Help();
      const auto range = FieldRange();
      const std::string_view field = Identifier("a field's name or '}'");
      if (!names.insert(field).second) Fail("two fields have this name");
      Expect(':');
      if (failed()) return {};
      ParsedType parsed = ParseType(depth + 1);
      const std::string_view unit = Unit();
      if (range && !parsed.schema.holds_numbers()) Fail("only a number can have a range");
      height = std::max(height, parsed.height);
      size += parsed.schema.minimum_size();
      if (size > kMaxValue) return Fail("a value of this type would exceed 2 GiB");
      fields.push_back({std::string(field), std::string(unit), std::move(parsed.schema),
                        std::string(help), range});
    }
    if (failed()) return {};
    return {Schema::Structure(std::move(name), std::move(fields)), height + 1};
  }

  ParsedType ParseEnum() {
    std::string name = TypeName();
    std::vector<Schema::Enumerator> enumerators;
    std::unordered_set<std::string_view> names;
    std::unordered_set<std::int32_t> values;
    Expect('{');
    while (!failed() && !Accept('}')) {
      const std::string_view enumerator = Identifier("an enumerator's name or '}'");
      Expect('=');
      const auto value = Number<std::int32_t>();
      if (!names.insert(enumerator).second) Fail("two enumerators have this name");
      if (!values.insert(value).second) Fail("two enumerators have this value");
      enumerators.push_back({std::string(enumerator), value});
    }
    if (enumerators.empty()) Fail("an enum has at least one enumerator");
    if (failed()) return {};
    return {Schema::Enum(std::move(name), std::move(enumerators)), 1};
  }

  /// Reads " in rad" up to the end of the line; empty if there is no unit.
  std::string_view Unit() {
    const auto unit = LineAfter(" in ");
    if (!unit) return {};
    if (unit->empty() || !payload::IsUnit(*unit)) Fail("expected a unit");
    SkipLine();
    return *unit;
  }

  /// Reads "# Of the fastest joint."; empty if there is no help line.
  std::string_view Help() {
    if (!Accept('#')) return {};
    const auto help = LineAfter(" ");
    if (!help || help->empty() || !payload::IsHelp(*help)) Fail("expected a line of help");
    SkipLine();
    return help.value_or(std::string_view());
  }

  /// Reads "@ 0 to 2.5"; empty if there is no range line.
  std::optional<Range> FieldRange() {
    if (!Accept('@')) return std::nullopt;
    auto rest = LineAfter(" ");
    Range range;
    if (!rest || !payload::ReadRange(*rest, range) || !rest->empty()) {
      Fail("expected a range, like 0 to 2.5");
    }
    SkipLine();
    return range;
  }

  /// Returns the text on this line after `start`; empty if the text at this position is not
  /// `start`.
  [[nodiscard]] std::optional<std::string_view> LineAfter(std::string_view start) const {
    const std::string_view rest = text_.substr(position_);
    const std::string_view line = rest.substr(0, rest.find('\n'));
    if (!line.starts_with(start)) return std::nullopt;
    return line.substr(start.size());
  }

  void SkipLine() { position_ = std::min(text_.find('\n', position_), text_.size()); }

  std::string TypeName() {
    const std::string_view name = Word();
    if (!payload::IsTypeName(name)) {
      position_ -= name.size();
      Fail("expected a type's name, like arm.JointState");
    }
    return std::string(name);
  }

  std::string_view Identifier(const char* what) {
    const std::string_view name = Word();
    if (!payload::IsIdentifier(name)) {
      position_ -= name.size();
      Fail(std::string("expected ") + what);
    }
    return name;
  }

  /// Reads the next word: letters, digits, dots and '_'.
  std::string_view Word() {
    SkipSpace();
    const std::size_t start = position_;
    while (position_ < text_.size() && IsWordCharacter(text_[position_])) ++position_;
    return text_.substr(start, position_ - start);
  }

  template <typename Integer>
  Integer Number() {
    SkipSpace();
    Integer value = 0;
    const char* const start = text_.data() + position_;
    const auto [end, code] = std::from_chars(start, text_.data() + text_.size(), value);
    if (code != std::errc{}) Fail("expected a number of 32 bits");
    position_ += static_cast<std::size_t>(end - start);
    return value;
  }

  bool Accept(char wanted) {
    const std::size_t before = position_;
    SkipSpace();
    if (position_ < text_.size() && text_[position_] == wanted) {
      ++position_;
      return true;
    }
    position_ = before;
    return false;
  }

  bool Expect(char wanted) {
    if (!failed() && !Accept(wanted)) {
      SkipSpace();
      Fail(std::string("expected '") + wanted + "'");
    }
    return !failed();
  }

  void SkipSpace() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\n')) {
      ++position_;
    }
  }

  ParsedType Fail(const std::string& what) {
    if (failed()) return {};
    const std::string_view before = text_.substr(0, position_);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = position_ - (before.rfind('\n') + 1) + 1;
    error_ = Error{ErrorCode::kInvalid, "schema line " + std::to_string(line) + " column " +
                                            std::to_string(column) + ": " + what};
    return {};
  }

  static bool IsWordCharacter(char c) {
    return payload::IsLetter(c) || payload::IsDigit(c) || c == '_' || c == '.';
  }

  static std::optional<Schema::Kind> SimpleKind(std::string_view word) {
    for (auto i = 0; i <= static_cast<int>(Schema::Kind::kDuration); ++i) {
      const auto kind = static_cast<Schema::Kind>(i);
      if (ToString(kind) == word) return kind;
    }
    return std::nullopt;
  }

  [[nodiscard]] bool failed() const { return error_.has_value(); }

  std::string_view text_;
  std::size_t position_ = 0;
  std::optional<Error> error_;
};

}  // namespace

Result<Schema> Schema::Parse(std::string_view text) {
  if (text.size() > kMaxText) {
    return Error{ErrorCode::kInvalid, "schema: " + std::to_string(text.size()) +
                                          " bytes of text; at most 1048576 are read"};
  }
  return Parser(text).Parse();
}

}  // namespace tendon
