#include <tendon/payload/numeric_value.h>

#include <array>
#include <charconv>
#include <cmath>

namespace tendon {
namespace {

constexpr double kPerSecond = 1e9;                     // ns
constexpr std::uint64_t kNanoseconds = 1'000'000'000;  // ns

template <typename T>
std::string Digits(T value) {
  std::array<char, 32> digits{};
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr};
}

/// Converts a float to text. Not-a-number gets no sign, because its sign has no meaning.
template <std::floating_point T>
std::string RealText(T value) {
  return std::isnan(value) ? "nan" : Digits(value);
}

std::string DurationText(std::int64_t nanoseconds) {
  const auto bits = static_cast<std::uint64_t>(nanoseconds);
  const std::uint64_t size = nanoseconds < 0 ? 0 - bits : bits;
  std::string text = (nanoseconds < 0 ? "-" : "") + Digits(size / kNanoseconds);
  if (size % kNanoseconds == 0) return text;
  std::string fraction = Digits(kNanoseconds + size % kNanoseconds);
  fraction.front() = '.';
  return text + fraction.substr(0, fraction.find_last_not_of('0') + 1);
}

}  // namespace

NumericValue::NumericValue(payload::CdrDuration duration)
    : kind_(Kind::kDuration),
      bits_(static_cast<std::uint64_t>(duration.sec) * kNanoseconds + duration.nanosec) {}

double NumericValue::real() const {
  switch (kind_) {
    case Kind::kFloat32:
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits_));
    case Kind::kFloat64:
      return std::bit_cast<double>(bits_);
    case Kind::kUnsigned:
      return static_cast<double>(bits_);
    case Kind::kDuration:
      return static_cast<double>(integer()) / kPerSecond;
    case Kind::kSigned:
      break;
  }
  return static_cast<double>(integer());
}

std::string ToString(const NumericValue& value) {
  switch (value.kind()) {
    case NumericValue::Kind::kFloat32:
      return RealText(static_cast<float>(value.real()));
    case NumericValue::Kind::kFloat64:
      return RealText(value.real());
    case NumericValue::Kind::kUnsigned:
      return Digits(static_cast<std::uint64_t>(value.integer()));
    case NumericValue::Kind::kDuration:
      return DurationText(value.integer());
    case NumericValue::Kind::kSigned:
      break;
  }
  return Digits(value.integer());
}

std::string ToString(const Schema& schema, const NumericValue& value) {
  if (schema.kind() == Schema::Kind::kBool) return value.integer() != 0 ? "true" : "false";
  for (const auto& enumerator : schema.enumerators()) {
    if (enumerator.value == value.integer()) return enumerator.name;
  }
  return ToString(value);
}

bool IsStepped(const Schema& schema) {
  const auto kind = schema.kind();
  return kind == Schema::Kind::kEnum ||
         (schema.is_number() && kind != Schema::Kind::kFloat32 && kind != Schema::Kind::kFloat64);
}

}  // namespace tendon
