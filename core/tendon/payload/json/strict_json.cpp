#include <tendon/payload/json/strict_json.h>

#include <tendon/base/text.h>
#include <tendon/payload/json/json_place.h>
#include <tendon/payload/json/number_literal.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <vector>

namespace tendon {
namespace {

constexpr std::size_t kMaxDepth = 64;

std::string TooDeep() { return "nesting deeper than " + std::to_string(kMaxDepth); }

/// True if the text has more than kMaxDepth levels. Called before the text is parsed.
bool IsTooDeep(std::string_view text) {
  std::size_t depth = 0;
  bool is_in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (is_in_string && letter == '\\') {
      ++i;
    } else if (letter == '"') {
      is_in_string = !is_in_string;
    } else if (!is_in_string && (letter == '[' || letter == '{')) {
      if (++depth > kMaxDepth) return true;
    } else if (!is_in_string && (letter == ']' || letter == '}') && depth > 0) {
      --depth;
    }
  }
  return false;
}

/// Returns the parser's message without its codes and positions: "unexpected ','; expected string
/// literal".
std::string Words(const std::string& what) {
  std::string words = what.substr(what.find("] ") == what.npos ? 0 : what.find("] ") + 2);
  if (words.starts_with("parse error at ")) words = words.substr(words.find(": ") + 2);
  const std::string phase = "syntax error while parsing ";
  if (words.starts_with(phase)) words = words.substr(words.find(" - ") + 3);
  return Printable(words, 200);
}

/// Returns the number of bytes from the start of the mistake to the parser's position. The parser's
/// `last_token` ends at this position. If the token is a string, it starts where the mistake
/// starts. Otherwise the token starts too early.
std::size_t OffendingLength(const std::string& words, const std::string& last_token) {
  if (words.starts_with("unexpected end")) return 0;
  if (words.starts_with("unexpected string")) return last_token.size();
  if (words.starts_with("unexpected '") || words.starts_with("invalid ")) return 1;
  const auto is_of_word = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '-' ||
           letter == '+' || letter == '.';
  };
  const auto begin = std::find_if_not(last_token.rbegin(), last_token.rend(), is_of_word);
  return static_cast<std::size_t>(begin - last_token.rbegin());
}

/// Replaces the locale's decimal sign by a point. The JSON library passes numbers with the locale's
/// sign.
std::string WithPoint(std::string number) {
  const std::size_t sign = number.find_first_not_of("+-0123456789eE.");
  if (sign == number.npos) return number;
  const std::size_t end = std::min(number.find_first_of("0123456789eE", sign), number.size());
  return number.replace(sign, end - sign, ".");
}

/// The numbers that become integers: only numbers written as integers, or all numbers with an
/// integer value.
enum class Integers { kAsWritten, kAreExact };

/// Builds the value and refuses mistakes that the grammar allows.
class StrictReader final : public nlohmann::json_sax<Json> {
 public:
  /// Stores the digits of fine numbers in `fine`, unless it is null.
  StrictReader(std::string_view text, Integers integers, FineNumbers* fine)
      : text_(text), integers_(integers), fine_(fine) {}

  bool null() override { return Add(nullptr); }
  bool boolean(bool value) override { return Add(value); }
  bool number_integer(number_integer_t value) override { return Add(value); }
  bool number_unsigned(number_unsigned_t value) override { return Add(value); }
  bool number_float(number_float_t /*value*/, const string_t& text) override {
    const std::string number = WithPoint(text);
    number_float_t value = 0;
    const auto code = std::from_chars(number.data(), number.data() + number.size(), value).ec;
    if (code != std::errc()) return Fail("no double can hold the number " + Printable(number, 64));
    const bool may_be_integer = std::trunc(value) == value && (value != 0 || !std::signbit(value));
    if (integers_ == Integers::kAreExact && may_be_integer) {
      for (const auto kind : {Schema::Kind::kInt64, Schema::Kind::kUint64}) {
        const NumberLiteral integer = ReadNumberLiteral(kind, number);
        if (integer.flaw == NumberFlaw::kNone) return AddInteger(integer.json);
      }
    }
    if (fine_ != nullptr && IsFinerThanDouble(number)) fine_->emplace(NextPlace(), number);
    return Add(value);
  }
  bool string(string_t& value) override { return Add(value); }
  bool binary(binary_t& /*value*/) override { return Fail("binary data"); }
  bool start_object(std::size_t /*size*/) override { return Enter(Json::object()); }
  bool start_array(std::size_t /*size*/) override { return Enter(Json::array()); }
  bool end_object() override { return Leave(); }
  bool end_array() override { return Leave(); }

  bool key(string_t& value) override {
    const OpenContainer& object = open_.back();
    if (object.value->contains(value)) {
      const std::string shown = Printable(value, 64);
      const std::string path = object.place + (object.place.empty() ? "" : ".") + shown;
      return Fail(PlaceOfSecondInJson(text_, path) + ": " + object.place +
                  (object.place.empty() ? "" : ": ") + "key '" + shown + "' occurs twice");
    }
    key_ = value;
    return true;
  }

  bool parse_error(std::size_t position, const std::string& last_token,
                   const nlohmann::detail::exception& reason) override {
    const std::string words = Words(reason.what());
    const std::size_t end = std::min(position, text_.size());
    return Fail(LineAndColumn(text_, end - std::min(end, OffendingLength(words, last_token))) +
                ": " + words);
  }

  Result<Json> Take() && {
    if (!error_.empty()) return Error{ErrorCode::kInvalid, error_};
    return std::move(root_);
  }

 private:
  /// A list or an object that has not ended yet.
  struct OpenContainer {
    Json* value;
    std::string place;  // "processes[0].components"
  };

  bool Fail(const std::string& reason) {
    error_ = reason;
    return false;
  }

  Json& Put(Json value) {
    if (open_.empty()) return root_ = std::move(value);
    Json& parent = *open_.back().value;
    if (parent.is_object()) return parent[key_] = std::move(value);
    parent.push_back(std::move(value));
    return parent.back();
  }

  bool Add(Json value) {
    Put(std::move(value));
    return true;
  }

  bool AddInteger(const std::string& digits) {
    const char* const end = digits.data() + digits.size();
    if (number_unsigned_t value = 0; std::from_chars(digits.data(), end, value).ptr == end) {
      return Add(value);
    }
    number_integer_t value = 0;
    std::from_chars(digits.data(), end, value);
    return Add(value);
  }

  bool Enter(Json container) {
    if (open_.size() == kMaxDepth) return Fail(TooDeep());
    const std::string place = NextPlace();
    open_.push_back({&Put(std::move(container)), place});
    return true;
  }

  bool Leave() {
    open_.pop_back();
    return true;
  }

  [[nodiscard]] std::string NextPlace() const {
    if (open_.empty()) return {};
    const auto& [parent, place] = open_.back();
    if (parent->is_array()) return place + "[" + std::to_string(parent->size()) + "]";
    return place + (place.empty() ? "" : ".") + Printable(key_, 64);
  }

  const std::string_view text_;
  const Integers integers_;
  FineNumbers* const fine_;
  Json root_;
  std::vector<OpenContainer> open_;  // from the root to the innermost
  std::string key_;
  std::string error_;
};

Result<Json> ReadStrictly(std::string_view text, Integers integers, FineNumbers* fine) {
  if (text.starts_with("\xef\xbb\xbf")) {
    return Error{ErrorCode::kInvalid,
                 "begins with a byte-order mark; save the text as UTF-8 without this mark"};
  }
  if (text.find_first_not_of(" \t\r\n") == text.npos) return Error{ErrorCode::kInvalid, "is empty"};
  StrictReader reader(text, integers, fine);
  Json::sax_parse(text, &reader);
  return std::move(reader).Take();
}

}  // namespace

Result<Json> ParseStrictJson(std::string_view text) {
  return ReadStrictly(text, Integers::kAsWritten, nullptr);
}

Result<Json> ParseExactJson(std::string_view text, FineNumbers* fine) {
  return ReadStrictly(text, Integers::kAreExact, fine);
}

Result<nlohmann::ordered_json> ParseOrderedJson(std::string_view text) {
  if (IsTooDeep(text)) return Error{ErrorCode::kInvalid, TooDeep()};
  auto value = nlohmann::ordered_json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (!value.is_discarded()) return value;
  const auto strict = ParseStrictJson(text);  // returns an error with the place
  return strict ? Error{ErrorCode::kInvalid, "is not valid JSON"} : strict.error();
}

nlohmann::ordered_json JsonOrText(std::string_view text) {
  auto value = ParseOrderedJson(text);
  if (value) return *std::move(value);
  return Printable(text, text.size());
}

std::string KindOf(const Json& value) {
  switch (value.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "a list";
    case Json::value_t::string:
      return "text";
    case Json::value_t::boolean:
      return "true or false";
    default:
      return "number";
  }
}

}  // namespace tendon
