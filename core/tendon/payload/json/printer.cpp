#include <tendon/payload/body_reader.h>
#include <tendon/payload/json.h>

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

namespace tendon {
namespace {

using payload::CdrReader;

std::string Quoted(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

template <typename Number>
void PrintNumber(Number number, std::string& out) {
  if constexpr (std::is_floating_point_v<Number>) {
    if (std::isnan(number)) {
      out += "\"nan\"";
      return;
    }
    if (std::isinf(number)) {
      out += number > 0 ? "\"inf\"" : "\"-inf\"";
      return;
    }
  }
  if constexpr (std::is_same_v<Number, bool>) {
    out += number ? "true" : "false";
  } else {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    out.append(digits.data(), end);
  }
}

/// "-1.5" for -2 s and 500,000,000 ns.
void PrintDuration(payload::CdrDuration duration, std::string& out) {
  std::int64_t sec = duration.sec;
  std::int64_t nanosec = duration.nanosec;
  if (sec < 0) {
    out += '-';
    sec = nanosec > 0 ? -sec - 1 : -sec;
    nanosec = nanosec > 0 ? 1'000'000'000 - nanosec : 0;
  }
  out += std::to_string(sec);
  if (nanosec == 0) return;
  std::string digits = std::to_string(1'000'000'000 + nanosec);
  digits.front() = '.';
  out += digits.substr(0, digits.find_last_not_of('0') + 1);
}

/// Prints a body; false, and what was expected in `expected`, where it does not decode.
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
        PrintDuration(duration, out_);
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
    out_ += Quoted(text);
    return true;
  }

  bool PrintEnum(const Schema& schema) {
    std::int32_t value = 0;
    if (!reader_.Read(value)) return Expected(schema.TypeName());
    for (const auto& enumerator : schema.enumerators()) {
      if (enumerator.value != value) continue;
      out_ += '"' + enumerator.name + '"';
      return true;
    }
    PrintNumber(value, out_);
    return true;
  }

  bool PrintList(const Schema& schema) {
    std::uint32_t count = 0;
    if (!payload::ReadElementCount(schema, reader_, count)) return Expected(schema.TypeName());
    out_ += '[';
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i > 0) out_ += ',';
      if (!Print(schema.element())) return false;
    }
    out_ += ']';
    return true;
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
    return Error{ErrorCode::kInvalid, "these " + std::to_string(body.size()) + " bytes are no " +
                                          schema.TypeName() + ": " + why};
  };
  Printer printer(body);
  if (!printer.Print(schema)) return malformed("no " + printer.expected() + " where one belongs");
  if (!printer.is_at_end()) return malformed("something follows it");
  return printer.Take();
}

}  // namespace tendon
