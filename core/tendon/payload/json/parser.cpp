#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/payload/body_reader.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/number_literal.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/schema/range.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

namespace tendon {
namespace {

/// Appends CDR to a growing body.
class BodyBuilder {
 public:
  template <typename T>
  void Write(T value) {
    body_.resize(payload::AlignUp(body_.size(), sizeof(T)));
    Append(&value, sizeof(T));
  }

  void WriteString(const std::string& text) {
    Write(static_cast<std::uint32_t>(text.size() + 1));
    Append(text.c_str(), text.size() + 1);
  }

  std::vector<std::byte> Take() { return std::move(body_); }

 private:
  void Append(const void* bytes, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(bytes);
    body_.insert(body_.end(), first, first + size);
  }

  std::vector<std::byte> body_;
};

/// Describes a value that a person typed: "string 'x'", "number 3", "an array of 2".
std::string Found(const Json& value) {
  constexpr std::size_t kShown = 40;  // bytes
  switch (value.type()) {
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "an array of " + std::to_string(value.size());
    case Json::value_t::string:
      return "string " + Quoted(value.get_ref<const std::string&>(), kShown);
    case Json::value_t::boolean:
    case Json::value_t::null:
      return value.dump();
    default:
      return "number " + value.dump();
  }
}

/// Converts a JSON number to this integer type; false if the type cannot hold it.
template <typename Integer>
bool ToInteger(const Json& value, Integer& out) {
  const auto narrow = [&](auto wide) {
    if (!std::in_range<Integer>(wide)) return false;
    out = static_cast<Integer>(wide);
    return true;
  };
  if (value.is_number_unsigned()) return narrow(value.get<std::uint64_t>());
  if (value.is_number_integer()) return narrow(value.get<std::int64_t>());
  return false;
}

template <typename Real>
bool ToReal(const Json& value, Real& out) {
  using Limits = std::numeric_limits<Real>;
  if (value.is_number()) {
    const auto number = value.get<double>();
    out = static_cast<Real>(number);  // may round to the largest float
    return !std::isinf(out) && (out == 0) == (number == 0);
  }
  if (!value.is_string()) return false;
  const std::string text = value.get<std::string>();
  if (text == "nan") {
    out = Limits::quiet_NaN();
  } else if (text == "inf" || text == "-inf") {
    out = text == "inf" ? Limits::infinity() : -Limits::infinity();
  } else {
    return false;
  }
  return true;
}

/// The unit and the range for all numbers in a value. They come from the innermost field that has
/// them.
struct Numbers {
  std::string unit;
  std::optional<Range> range;

  template <typename Number>
  [[nodiscard]] bool Allow(Number number) const {
    if (!range) return true;
    const auto real = static_cast<double>(number);
    return real >= range->lowest && real <= range->highest;  // not-a-number is in no range
  }
  /// "a number" or "a number from 0 to 2.5".
  [[nodiscard]] std::string Named(const std::string& what) const {
    return range ? what + " from " + payload::ToString(*range) : what;
  }
};

/// Converts a parsed document to a body, by its schema. Stops at the first mistake.
class Builder {
 public:
  explicit Builder(FineNumbers fine) : fine_(std::move(fine)) {}

  bool Build(const Schema& schema, const Json& value, const Numbers& numbers) {
    switch (schema.kind()) {
      case Schema::Kind::kString:
        return BuildString(value, numbers);
      case Schema::Kind::kDuration:
        return BuildDuration(value, numbers);
      case Schema::Kind::kEnum:
        return BuildEnum(schema, value);
      case Schema::Kind::kArray:
      case Schema::Kind::kSequence:
        return BuildList(schema, value, numbers);
      case Schema::Kind::kStructure:
        return BuildStructure(schema, value, numbers);
      default:
        return payload::WithNumber(schema.kind(), [&](auto number) {
          return BuildNumber(number, schema, value, numbers);
        });
    }
  }

  [[nodiscard]] const std::string& mistake() const { return mistake_; }
  std::vector<std::byte> Take() { return body_.Take(); }

 private:
  template <typename Number>
  bool BuildNumber(Number number, const Schema& schema, const Json& value, const Numbers& numbers) {
    if constexpr (std::is_same_v<Number, bool>) {
      if (!value.is_boolean()) return Expected("true or false", numbers.unit, value);
      number = value.get<bool>();
    } else if constexpr (std::is_floating_point_v<Number>) {
      if (!ToReal(value, number)) {
        const bool too_large = value.is_number();
        return Expected(too_large ? "a number that " + schema.TypeName() + " can hold" : "a number",
                        numbers.unit, value);
      }
      if (!numbers.Allow(number)) return Expected(numbers.Named("a number"), numbers.unit, value);
    } else {
      using Limits = std::numeric_limits<Number>;
      if (!ToInteger(value, number)) {
        return Expected("an integer from " + std::to_string(Limits::min()) + " to " +
                            std::to_string(Limits::max()),
                        numbers.unit, value);
      }
      if (!numbers.Allow(number)) return Expected(numbers.Named("an integer"), numbers.unit, value);
    }
    body_.Write(number);
    return true;
  }

  bool BuildString(const Json& value, const Numbers& numbers) {
    if (!value.is_string()) return Expected("a string", numbers.unit, value);
    const auto& text = value.get_ref<const std::string&>();
    // In DDS and ROS a zero ends a string, so the receiver would get a different string.
    if (text.find('\0') != text.npos) return Expected("a string without \\u0000", "", value);
    body_.WriteString(text);
    return true;
  }

  bool BuildDuration(const Json& value, const Numbers& numbers) {
    constexpr double kLimit = 2147483648.0;  // s
    using Seconds = std::chrono::duration<double>;
    const auto exact = FineDuration(value);
    if (!exact && (!value.is_number() || std::abs(value.get<double>()) >= kLimit)) {
      return Expected("a number of seconds, below 68 years", numbers.unit, value);
    }
    const double seconds = exact ? Seconds(*exact).count() : value.get<double>();
    if (!numbers.Allow(seconds)) {
      return Expected(numbers.Named("a number of seconds"), numbers.unit, value);
    }
    const auto duration = exact ? Exactly(*exact) : payload::ToCdr(Seconds(seconds));
    if (seconds != 0 && duration.sec == 0 && duration.nanosec == 0) {
      return Expected("a number of seconds, in steps of 1e-9", numbers.unit, value);
    }
    body_.Write(duration.sec);
    body_.Write(duration.nanosec);
    return true;
  }

  static payload::CdrDuration Exactly(std::chrono::nanoseconds time) {
    const auto whole = std::chrono::floor<std::chrono::seconds>(time);
    return {static_cast<std::int32_t>(whole.count()),
            static_cast<std::uint32_t>((time - whole).count())};
  }

  /// Reads a duration whose nanoseconds a double cannot hold. The value may be a number. It may
  /// also be a string of digits, which is sent by programs that store numbers as doubles. Returns
  /// nothing for all other values.
  std::optional<std::chrono::nanoseconds> FineDuration(const Json& value) {
    if (const auto fine = fine_.find(path_); value.is_number_float() && fine != fine_.end()) {
      return NanosecondsIn(fine->second);
    }
    if (!value.is_string()) return std::nullopt;
    const auto& digits = value.get_ref<const std::string&>();
    return IsFinerThanDouble(digits) ? NanosecondsIn(digits) : std::nullopt;
  }

  bool BuildEnum(const Schema& schema, const Json& value) {
    std::vector<std::string> names;
    std::string list;
    for (const auto& enumerator : schema.enumerators()) {
      if (value.is_string() && value.get_ref<const std::string&>() == enumerator.name) {
        body_.Write(enumerator.value);
        return true;
      }
      names.push_back(enumerator.name);
      list += (list.empty() ? "'" : ", '") + enumerator.name + "'";
    }
    Expected("one of " + list, "", value);
    if (value.is_string()) mistake_ += DidYouMean(value.get<std::string>(), names);
    return false;
  }

  bool BuildList(const Schema& list, const Json& value, const Numbers& numbers) {
    const bool fixed = list.kind() == Schema::Kind::kArray;
    if (!value.is_array() || (fixed && value.size() != list.length())) {
      const std::string many = fixed ? std::to_string(list.length()) + " " : "";
      return Expected("an array of " + many + list.element().TypeName(), numbers.unit, value);
    }
    if (!fixed) body_.Write(static_cast<std::uint32_t>(value.size()));
    for (std::size_t i = 0; i < value.size(); ++i) {
      const bool good = Inside("[" + std::to_string(i) + "]",
                               [&] { return Build(list.element(), value[i], numbers); });
      if (!good) return false;
    }
    return true;
  }

  bool BuildStructure(const Schema& schema, const Json& value, const Numbers& numbers) {
    if (schema.is_none()) {
      if (!value.is_null() && !(value.is_object() && value.empty())) {
        return Expected("null", "", value);
      }
      body_.Write(std::uint8_t{0});
      return true;
    }
    if (!value.is_object())
      return Expected("an object (" + schema.name() + ")", numbers.unit, value);
    if (!HasOnlyFields(schema, value)) return false;
    for (const Schema::Field& field : schema.fields()) {
      const auto found = value.find(field.name);
      if (found == value.end()) return Mistake(Missing(field));
      const Numbers inner{field.unit.empty() ? numbers.unit : field.unit,
                          field.range ? field.range : numbers.range};
      const bool good = Inside((path_.empty() ? "" : ".") + field.name,
                               [&] { return Build(field.schema, *found, inner); });
      if (!good) return false;
    }
    return true;
  }

  bool HasOnlyFields(const Schema& schema, const Json& value) {
    std::vector<std::string> names;
    for (const Schema::Field& field : schema.fields()) names.push_back(field.name);
    for (const auto& item : value.items()) {
      if (std::find(names.begin(), names.end(), item.key()) != names.end()) continue;
      return Mistake("unknown key " + Quoted(item.key(), 64) + DidYouMean(item.key(), names));
    }
    return true;
  }

  static std::string Missing(const Schema::Field& field) {
    return "missing key '" + field.name + "' (" + field.schema.TypeName() +
           (field.unit.empty() ? "" : " in " + field.unit) + ")";
  }

  bool Expected(const std::string& what, const std::string& unit, const Json& value) {
    return Mistake("expected " + what + (unit.empty() ? "" : " (" + unit + ")") + ", got " +
                   Found(value));
  }

  bool Mistake(const std::string& what) {
    mistake_ = path_.empty() ? what : path_ + ": " + what;
    return false;
  }

  template <typename Action>
  bool Inside(const std::string& step, Action action) {
    const std::size_t size = path_.size();
    path_ += step;
    const bool good = action();
    path_.resize(size);
    return good;
  }

  const FineNumbers fine_;
  BodyBuilder body_;
  std::string path_;
  std::string mistake_;
};

bool HasDuration(const Schema& schema) {
  switch (schema.kind()) {
    case Schema::Kind::kDuration:
      return true;
    case Schema::Kind::kArray:
    case Schema::Kind::kSequence:
      return HasDuration(schema.element());
    case Schema::Kind::kStructure:
      return std::ranges::any_of(schema.fields(), HasDuration, &Schema::Field::schema);
    default:
      return false;
  }
}

Error Invalid(std::string message) { return {ErrorCode::kInvalid, std::move(message)}; }

}  // namespace

Result<std::vector<std::byte>> FromJson(const Schema& schema, std::string_view json_text) {
  constexpr std::size_t kMaxText = std::size_t{16} << 20U;
  if (json_text.size() > kMaxText) {
    return Invalid("this JSON has " + std::to_string(json_text.size()) +
                   " bytes; at most 16777216 are read");
  }
  const bool blank = json_text.find_first_not_of(" \t\r\n") == std::string_view::npos;
  if (blank && !schema.is_none()) return Invalid("expected " + schema.TypeName() + ", got nothing");
  FineNumbers fine;
  const auto document =
      ParseExactJson(blank ? "null" : json_text, HasDuration(schema) ? &fine : nullptr);
  if (!document) return Invalid("this is not valid JSON: " + document.error().message);
  Builder builder(std::move(fine));
  if (!builder.Build(schema, *document, {})) return Invalid(builder.mistake());
  return builder.Take();
}

}  // namespace tendon
