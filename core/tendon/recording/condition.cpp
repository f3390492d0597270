#include <tendon/recording/condition.h>

#include <tendon/base/text.h>
#include <tendon/payload/schema/values_text.h>

#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

namespace tendon::recording {
namespace {

using Relation = Condition::Relation;

struct RelationSign {
  std::string_view sign;
  Relation relation;
};
/// Longer signs come first, because "<=" begins with "<".
constexpr auto kSigns = std::to_array<RelationSign>({{"<=", Relation::kLessOrEqual},
                                                     {">=", Relation::kGreaterOrEqual},
                                                     {"==", Relation::kEqual},
                                                     {"!=", Relation::kNotEqual},
                                                     {"<", Relation::kLess},
                                                     {">", Relation::kGreater}});

constexpr std::string_view kSpace = " \t";

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kSpace);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(kSpace) - begin + 1);
}

Error Mistake(std::string_view text, std::size_t place, const std::string& expected) {
  return {ErrorCode::kInvalid, Quoted(text, 200) + " is not a condition: column " +
                                   std::to_string(place + 1) + ": expected " + expected};
}

Error DoesNotFit(const Condition& condition, const std::string& why) {
  return {ErrorCode::kInvalid, Quoted(condition.text, 200) + ": " + why};
}

template <typename T>
std::optional<long double> ReadAs(const std::string& text) {
  T value{};
  const char* const end = text.data() + text.size();
  const auto [read, failure] = std::from_chars(text.data(), end, value);
  if (failure != std::errc() || read != end) return std::nullopt;
  return static_cast<long double>(value);
}

std::optional<long double> ReadAsNumber(const std::string& text) {
  if (const auto number = ReadAs<std::int64_t>(text)) return number;
  if (const auto number = ReadAs<std::uint64_t>(text)) return number;
  return ReadAs<double>(text);
}

Result<long double> ValueFor(const Condition& condition, const Schema& type) {
  const std::string& value = condition.comparison->value;
  if (type.kind() == Schema::Kind::kBool) {
    if (value == "true") return 1.0L;
    if (value == "false") return 0.0L;
    return DoesNotFit(condition, "expected true or false, found '" + value + "'");
  }
  if (type.kind() == Schema::Kind::kEnum) {
    if (const auto* one = FindNamed(type.enumerators(), value)) return one->value;
    return DoesNotFit(condition, "expected one of " + ValuesText({.name = {}, .schema = type}) +
                                     "; found '" + value + "'");
  }
  if (const auto number = ReadAsNumber(value)) return *number;
  return DoesNotFit(condition, "expected a number, found '" + value + "'");
}

long double NumberOf(const NumericValue& value) {
  switch (value.kind()) {
    case NumericValue::Kind::kUnsigned:
      return static_cast<long double>(static_cast<std::uint64_t>(value.integer()));
    case NumericValue::Kind::kSigned:
      return static_cast<long double>(value.integer());
    case NumericValue::Kind::kDuration:
      return static_cast<long double>(value.integer()) / 1e9L;
    case NumericValue::Kind::kFloat32:
    case NumericValue::Kind::kFloat64:
      break;
  }
  return value.real();
}

}  // namespace

Result<Condition> ParseCondition(std::string_view text) {
  Condition condition{.text = std::string(text), .path = {}, .comparison = {}};
  const std::size_t place = text.find_first_of("<>=!");
  const std::string_view left = Trimmed(text.substr(0, place));
  if (left.empty()) {
    return Mistake(text, 0, "the path of an event or a command, or of a column and a comparison");
  }
  auto path = ParsePath(left);
  if (!path) return path.error();
  condition.path = *std::move(path);
  if (condition.path.member.empty()) {
    return Mistake(text, text.find(left) + left.size(), "'.' and an event, a command or a column");
  }
  if (place == text.npos) return condition;
  std::string_view rest = text.substr(place);
  for (const auto& [sign, relation] : kSigns) {
    if (!rest.starts_with(sign)) continue;
    const std::string_view right = Trimmed(rest.substr(sign.size()));
    if (right.empty()) {
      return Mistake(text, place + sign.size(), "a number, true, false, or a name");
    }
    const std::size_t end = right.find_first_of(kSpace);
    const std::string_view unit = end == right.npos ? "" : Trimmed(right.substr(end));
    if (unit.find_first_of(kSpace) != unit.npos) {
      return Mistake(text, text.find(unit) + unit.find_first_of(kSpace),
                     "the end of the condition after the unit");
    }
    condition.comparison = {relation, std::string(right.substr(0, end)), std::string(unit)};
    return condition;
  }
  return Mistake(text, place, "one of < <= > >= == !=");
}

Result<CellTest> CellTest::Make(const Condition& condition, const Schema& column) {
  const Condition::Comparison& comparison = *condition.comparison;
  auto field = FindNumericField(column, condition.path.field);
  if (!field) {
    return Error{field.error().code, Quoted(condition.text, 200) + ": " + field.error().message};
  }
  if (!comparison.unit.empty() && comparison.unit != field->unit) {
    return DoesNotFit(
        condition,
        field->unit.empty()
            ? "the value has no unit, but the condition has the unit '" + comparison.unit + "'"
            : "the value is in " + field->unit + ", but the condition uses " + comparison.unit);
  }
  const Schema::Kind kind = field->schema.kind();
  const bool has_order = kind != Schema::Kind::kBool && kind != Schema::Kind::kEnum;
  const bool needs_order =
      comparison.relation != Relation::kEqual && comparison.relation != Relation::kNotEqual;
  if (needs_order && !has_order) {
    return DoesNotFit(condition, "expected == or != for a " + field->schema.TypeName());
  }
  const auto value = ValueFor(condition, field->schema);
  if (!value) return value.error();
  return CellTest(*std::move(field), comparison.relation, *value);
}

bool CellTest::IsTrue(std::span<const std::byte> cell) const {
  const auto read = ReadExactly(field_, cell);
  if (!read) return false;
  const long double number = NumberOf(*read);
  switch (relation_) {
    case Relation::kLess:
      return number < value_;
    case Relation::kLessOrEqual:
      return number <= value_;
    case Relation::kGreater:
      return number > value_;
    case Relation::kGreaterOrEqual:
      return number >= value_;
    case Relation::kEqual:
      return number == value_;
    case Relation::kNotEqual:
      return number != value_;
  }
  return false;
}

}  // namespace tendon::recording
