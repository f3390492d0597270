#include <tendon/base/name.h>
#include <tendon/payload/body_reader.h>
#include <tendon/payload/json.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

namespace tendon {
namespace {

using nlohmann::json;

/// Appends CDR to a body that grows.
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

/// What a person typed, short: "string 'x'", "number 3", "an array of 2".
std::string Found(const json& value) {
  constexpr std::size_t kShown = 40;
  switch (value.type()) {
    case json::value_t::object:
      return "an object";
    case json::value_t::array:
      return "an array of " + std::to_string(value.size());
    case json::value_t::string: {
      const std::string text = value.get<std::string>();
      return "string '" + text.substr(0, kShown) + (text.size() > kShown ? "..." : "") + "'";
    }
    case json::value_t::boolean:
    case json::value_t::null:
      return value.dump();
    default:
      return "number " + value.dump();
  }
}

/// Whether a JSON number is this integer type's; fills it in.
template <typename Integer>
bool ToInteger(const json& value, Integer& out) {
  const auto narrow = [&](auto wide) {
    if (!std::in_range<Integer>(wide)) return false;
    out = static_cast<Integer>(wide);
    return true;
  };
  if (value.is_number_unsigned()) return narrow(value.get<std::uint64_t>());
  if (value.is_number_integer()) return narrow(value.get<std::int64_t>());
  if (!value.is_number_float()) return false;
  constexpr double kExact = 9007199254740992.0;  // 2^53: beyond it a double skips integers
  const double number = value.get<double>();
  if (std::trunc(number) != number || std::abs(number) > kExact) return false;
  return narrow(static_cast<std::int64_t>(number));
}

template <typename Real>
bool ToReal(const json& value, Real& out) {
  using Limits = std::numeric_limits<Real>;
  if (value.is_number()) {
    const double number = value.get<double>();
    if (std::abs(number) > static_cast<double>(Limits::max())) return false;
    out = static_cast<Real>(number);
    return true;
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

/// Turns a parsed document into a body, schema in hand. The first mistake ends it.
class Builder {
 public:
  bool Build(const Schema& schema, const json& value, const std::string& unit) {
    switch (schema.kind()) {
      case Schema::Kind::kString:
        if (!value.is_string()) return Expected("a string", unit, value);
        body_.WriteString(value.get<std::string>());
        return true;
      case Schema::Kind::kDuration:
        return BuildDuration(value, unit);
      case Schema::Kind::kEnum:
        return BuildEnum(schema, value);
      case Schema::Kind::kArray:
      case Schema::Kind::kSequence:
        return BuildList(schema, value, unit);
      case Schema::Kind::kStructure:
        return BuildStructure(schema, value, unit);
      default:
        return payload::WithNumber(
            schema.kind(), [&](auto number) { return BuildNumber(number, schema, value, unit); });
    }
  }

  [[nodiscard]] const std::string& mistake() const { return mistake_; }
  std::vector<std::byte> Take() { return body_.Take(); }

 private:
  template <typename Number>
  bool BuildNumber(Number number, const Schema& schema, const json& value,
                   const std::string& unit) {
    if constexpr (std::is_same_v<Number, bool>) {
      if (!value.is_boolean()) return Expected("true or false", unit, value);
      number = value.get<bool>();
    } else if constexpr (std::is_floating_point_v<Number>) {
      if (!ToReal(value, number)) {
        return Expected(
            value.is_number() ? "a number that " + schema.TypeName() + " can hold" : "a number",
            unit, value);
      }
    } else {
      if (!ToInteger(value, number)) {
        using Limits = std::numeric_limits<Number>;
        return Expected("an integer from " + std::to_string(Limits::min()) + " to " +
                            std::to_string(Limits::max()),
                        unit, value);
      }
    }
    body_.Write(number);
    return true;
  }

  bool BuildDuration(const json& value, const std::string& unit) {
    constexpr double kLimit = 2147483648.0;  // s
    if (!value.is_number() || std::abs(value.get<double>()) >= kLimit) {
      return Expected("a number of seconds, below 68 years", unit, value);
    }
    const auto duration = payload::ToCdr(std::chrono::duration<double>(value.get<double>()));
    body_.Write(duration.sec);
    body_.Write(duration.nanosec);
    return true;
  }

  bool BuildEnum(const Schema& schema, const json& value) {
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

  bool BuildList(const Schema& list, const json& value, const std::string& unit) {
    const bool fixed = list.kind() == Schema::Kind::kArray;
    if (!value.is_array() || (fixed && value.size() != list.length())) {
      const std::string many = fixed ? std::to_string(list.length()) + " " : "";
      return Expected("an array of " + many + list.element().TypeName(), unit, value);
    }
    if (!fixed) body_.Write(static_cast<std::uint32_t>(value.size()));
    for (std::size_t i = 0; i < value.size(); ++i) {
      const bool good = Inside("[" + std::to_string(i) + "]",
                               [&] { return Build(list.element(), value[i], unit); });
      if (!good) return false;
    }
    return true;
  }

  bool BuildStructure(const Schema& schema, const json& value, const std::string& unit) {
    if (schema.is_none()) {
      if (!value.is_null() && !(value.is_object() && value.empty())) {
        return Expected("null", "", value);
      }
      body_.Write(std::uint8_t{0});
      return true;
    }
    if (!value.is_object()) return Expected("an object (" + schema.name() + ")", unit, value);
    if (!HasOnlyFields(schema, value)) return false;
    for (const Schema::Field& field : schema.fields()) {
      const auto found = value.find(field.name);
      if (found == value.end()) return Mistake(Missing(field));
      const std::string& inner = field.unit.empty() ? unit : field.unit;
      const bool good = Inside((path_.empty() ? "" : ".") + field.name,
                               [&] { return Build(field.schema, *found, inner); });
      if (!good) return false;
    }
    return true;
  }

  bool HasOnlyFields(const Schema& schema, const json& value) {
    std::vector<std::string> names;
    for (const Schema::Field& field : schema.fields()) names.push_back(field.name);
    for (const auto& item : value.items()) {
      if (std::find(names.begin(), names.end(), item.key()) != names.end()) continue;
      return Mistake("unknown key '" + item.key() + "'" + DidYouMean(item.key(), names));
    }
    return true;
  }

  static std::string Missing(const Schema::Field& field) {
    return "missing key '" + field.name + "' (" + field.schema.TypeName() +
           (field.unit.empty() ? "" : " in " + field.unit) + ")";
  }

  bool Expected(const std::string& what, const std::string& unit, const json& value) {
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

  BodyBuilder body_;
  std::string path_;
  std::string mistake_;
};

Error Invalid(std::string message) { return {ErrorCode::kInvalid, std::move(message)}; }

/// The parser's words without its own error number: "[json.exception.parse_error.101] parse ...".
std::string Reason(const json::exception& error) {
  const std::string_view what = error.what();
  const std::size_t end = what.find("] ");
  return std::string(end == std::string_view::npos ? what : what.substr(end + 2));
}

}  // namespace

Result<std::vector<std::byte>> FromJson(const Schema& schema, std::string_view json_text) {
  const bool blank = json_text.find_first_not_of(" \t\r\n") == std::string_view::npos;
  if (blank && schema.is_none()) json_text = "null";
  json document;
  try {
    document = json::parse(json_text);
  } catch (const json::exception& error) {
    return Invalid("this is no JSON: " + Reason(error));
  }
  Builder builder;
  if (!builder.Build(schema, document, "")) return Invalid(builder.mistake());
  return builder.Take();
}

}  // namespace tendon
