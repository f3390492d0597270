#include <tendon/payload/body_reader.h>
#include <tendon/payload/json.h>
#include <tendon/payload/numeric_value.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

namespace tendon {
namespace {

using payload::CdrReader;

std::string JsonText(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

constexpr std::size_t kLongestNumber = 32;

char* CopyTo(std::string_view text, char* to) { return std::ranges::copy(text, to).out; }

/// Writes at most kLongestNumber characters and returns their end.
template <typename Number>
char* NumberTo(Number number, char* to) {
  if constexpr (std::is_floating_point_v<Number>) {
    if (std::isnan(number)) return CopyTo("\"nan\"", to);
    if (std::isinf(number)) return CopyTo(number > 0 ? "\"inf\"" : "\"-inf\"", to);
  }
  if constexpr (std::is_same_v<Number, bool>) {
    return CopyTo(number ? "true" : "false", to);
  } else if (std::is_floating_point_v<Number> && number == 0 && std::signbit(number)) {
    return CopyTo("-0.0", to);  // readers take -0 for the integer 0, which loses the sign
  } else {
    return std::to_chars(to, to + kLongestNumber, number).ptr;
  }
}

template <typename Number>
void PrintNumber(Number number, std::string& out) {
  std::array<char, kLongestNumber> digits{};
  out.append(digits.data(), NumberTo(number, digits.data()));
}

bool IsNumber(Schema::Kind kind) { return kind <= Schema::Kind::kFloat64; }

/// Prints a body. If it cannot be decoded, returns false and sets `expected`.
class Printer {
 public:
  explicit Printer(std::span<const std::byte> body) : reader_(body) {}

  bool Print(const Schema& schema) {
    switch (schema.kind()) {
      case Schema::Kind::kString:
        return PrintString();
      case Schema::Kind::kDuration: {
        payload::CdrDuration duration;
        if (!payload::ReadDuration(reader_, duration)) return Expected("a duration");
        out_ += ToString(NumericValue(duration));
        return true;
      }
      case Schema::Kind::kEnum:
        return PrintEnum(schema);
      case Schema::Kind::kArray:
      case Schema::Kind::kSequence:
        return PrintList(schema);
      case Schema::Kind::kStructure:
        return PrintStructure(schema);
      default:
        return payload::WithNumber(schema.kind(), [&](auto number) {
          if (!reader_.Read(number)) return Expected(schema.TypeName());
          PrintNumber(number, out_);
          return true;
        });
    }
  }

  [[nodiscard]] bool is_at_end() const { return reader_.AtEnd(); }
  [[nodiscard]] const std::string& expected() const { return expected_; }
  std::string Take() { return std::move(out_); }

 private:
  bool PrintString() {
    std::string_view text;
    if (!reader_.ReadString(text)) return Expected("a string");
    out_ += JsonText(text);
    return true;
  }

  bool PrintEnum(const Schema& schema) {
    std::int32_t value = 0;
    if (!reader_.Read(value)) return Expected(schema.TypeName());
    out_ += ToJson(schema, NumericValue(value));
    return true;
  }

  bool PrintList(const Schema& schema) {
    std::uint32_t count = 0;
    if (!payload::ReadElementCount(schema, reader_, count)) return Expected(schema.TypeName());
    if (IsNumber(schema.element().kind())) return PrintNumbers(schema.element(), count);
    out_ += '[';
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i > 0) out_ += ',';
      if (!Print(schema.element())) return false;
    }
    out_ += ']';
    return true;
  }

  /// Prints a list of numbers. The list may be an image with millions of numbers, so the type is
  /// looked up only once, and memory is reserved for many numbers at a time.
  bool PrintNumbers(const Schema& element, std::uint32_t count) {
    return payload::WithNumber(element.kind(), [&](auto number) {
      constexpr std::size_t kAtOneGo = 4096;
      out_ += '[';
      std::size_t used = out_.size();
      for (std::uint32_t i = 0; i < count; ++i) {
        if (!reader_.Read(number)) {
          out_.resize(used);
          return Expected(element.TypeName());
        }
        if (out_.size() - used < kLongestNumber + 1) out_.resize(used + kAtOneGo);
        if (i > 0) out_[used++] = ',';
        used = static_cast<std::size_t>(NumberTo(number, out_.data() + used) - out_.data());
      }
      out_.resize(used);
      out_ += ']';
      return true;
    });
  }

  bool PrintStructure(const Schema& schema) {
    if (schema.is_none()) {
      out_ += "null";
      return reader_.Skip(1, 1) || Expected(schema.TypeName());
    }
    out_ += '{';
    bool first = true;
    for (const Schema::Field& field : schema.fields()) {
      if (!first) out_ += ',';
      first = false;
      out_ += '"' + field.name + "\":";
      if (!Print(field.schema)) return false;
    }
    out_ += '}';
    return true;
  }

  bool Expected(std::string what) {
    expected_ = std::move(what);
    return false;
  }

  CdrReader reader_;
  std::string out_;
  std::string expected_;
};

}  // namespace

Result<std::string> ToJson(const Schema& schema, std::span<const std::byte> body) {
  const auto malformed = [&](const std::string& why) {
    return Error{ErrorCode::kInvalid, "these " + std::to_string(body.size()) +
                                          " bytes are not a valid " + schema.TypeName() + ": " +
                                          why};
  };
  Printer printer(body);
  if (!printer.Print(schema)) return malformed("expected " + printer.expected() + ", found none");
  if (!printer.is_at_end()) return malformed("there is more data after the end of the value");
  return printer.Take();
}

std::string ToJson(const Schema& number, const NumericValue& value) {
  std::string out;
  if (value.kind() == NumericValue::Kind::kFloat32) {
    PrintNumber(static_cast<float>(value.real()), out);
  } else if (value.kind() == NumericValue::Kind::kFloat64) {
    PrintNumber(value.real(), out);
  } else {
    out = ToString(number, value);
    if (number.kind() == Schema::Kind::kEnum && out != ToString(value)) out = '"' + out + '"';
  }
  return out;
}

}  // namespace tendon
