#pragma once

#include <tendon/base/error.h>
#include <tendon/payload/aggregate.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>

namespace tendon {

/// The value of kPayload for a type without a description.
struct NotDescribed {};

/// Describes a user's type. The description is written once, beside the type; codec, fingerprint,
/// schema, numeric fields and JSON are derived from it. Specialise kPayload with Describe(...) or
/// DescribeEnum(...).
template <typename T>
inline constexpr auto kPayload = NotDescribed{};

/// The range of numbers that a field should hold, including both ends; in seconds for a duration.
struct Range {
  double lowest = 0;
  double highest = 0;

  bool operator==(const Range&) const = default;
};

/// One named member of a structure. `unit` is part of the type: a field in rad does not connect to
/// a field in deg. Help and range are not part of the type, but are sent with the schema. Viewers,
/// forms and the JSON reader use them.
///
///     Field{"speed", &Goal::speed, "rad/s"}.Within(0, 2.5).Help("Of the fastest joint.")
template <typename Owner, typename Member>
struct Field {
  using Type = Member;

  std::string_view name;
  Member Owner::*member;
  std::string_view unit = {};
  std::string_view help = {};
  std::optional<Range> range = {};

  /// Returns the member of `value`.
  template <typename Value>
  [[nodiscard]] constexpr auto& Of(Value& value) const {
    return value.*member;
  }

  /// Sets the range. Allowed for a number, a duration, or a list of these.
  [[nodiscard]] constexpr Field Within(double lowest, double highest) const {
    return {name, member, unit, help, Range{lowest, highest}};
  }
  /// Sets the help text, which is one line.
  [[nodiscard]] constexpr Field Help(std::string_view line) const {
    return {name, member, unit, line, range};
  }
};
template <typename Owner, typename Member>
Field(std::string_view, Member Owner::*, std::string_view = {}) -> Field<Owner, Member>;

/// The name of a field, and its unit if it has one: "position" or "position in rad". For a
/// structure that is described without pointers to its members.
///
///     FieldName("speed in rad/s").Within(0, 2.5).Help("Of the fastest joint.")
struct FieldName {
  // NOLINTNEXTLINE(google-explicit-constructor): so that a text is enough
  consteval FieldName(std::string_view text) : name(text.substr(0, text.find(kIn))) {
    if (name.size() < text.size()) unit = text.substr(name.size() + kIn.size());
  }
  // NOLINTNEXTLINE(google-explicit-constructor)
  consteval FieldName(const char* text) : FieldName(std::string_view(text)) {}

  /// See Field.
  [[nodiscard]] consteval FieldName Within(double lowest, double highest) const {
    FieldName result = *this;
    result.range = Range{lowest, highest};
    return result;
  }
  [[nodiscard]] consteval FieldName Help(std::string_view line) const {
    FieldName result = *this;
    result.help = line;
    return result;
  }

  std::string_view name;
  std::string_view unit = {};
  std::string_view help = {};
  std::optional<Range> range = {};

 private:
  static constexpr std::string_view kIn = " in ";
};

namespace payload {
/// A field of an aggregate that has kCount fields, found by its position.
template <typename Owner, std::size_t kIndex, std::size_t kCount>
struct FieldByPosition {
  using Type = std::remove_cvref_t<decltype(MemberAt<kIndex, kCount>(std::declval<Owner&>()))>;

  template <typename Value>
  [[nodiscard]] static constexpr auto& Of(Value& value) {
    return MemberAt<kIndex, kCount>(value);
  }

  std::string_view name;
  std::string_view unit;
  std::string_view help;
  std::optional<Range> range;
};

/// One field of a FieldList. The index makes the base classes of FieldList different types.
template <std::size_t kIndex, typename AField>
struct FieldAt {
  AField field;
};
/// The fields of a structure. A std::tuple would also work, but would take ten times as long to
/// compile, in each source file that describes a payload.
template <typename Indices, typename... Fields>
struct FieldList;
template <std::size_t... kIndices, typename... Fields>
struct FieldList<std::index_sequence<kIndices...>, Fields...> : FieldAt<kIndices, Fields>... {
  /// Calls `visit(field...)` with all fields.
  template <typename Visitor>
  constexpr decltype(auto) Visit(Visitor&& visit) const {
    return std::forward<Visitor>(visit)(FieldAt<kIndices, Fields>::field...);
  }
};

}  // namespace payload

/// A structure: its name on the network and its fields, in wire order.
template <typename... Fields>
struct Description {
  std::string_view name;
  payload::FieldList<std::index_sequence_for<Fields...>, Fields...> fields;
};

/// One named value of an enum.
template <typename Enum>
struct Enumerator {
  std::string_view name;
  Enum value;
};
template <typename Enum>
Enumerator(std::string_view, Enum) -> Enumerator<Enum>;

/// An enum: its name on the network and the only values that it may have.
template <typename Enum, std::size_t kCount>
struct EnumDescription {
  std::string_view name;
  std::array<Enumerator<Enum>, kCount> enumerators;
};

namespace payload {

constexpr std::size_t kMaxTypeName = 128;
constexpr std::size_t kMaxFieldName = 64;
constexpr std::size_t kMaxUnit = 32;
constexpr std::size_t kMaxHelp = 200;

constexpr bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
constexpr bool IsDigit(char c) { return c >= '0' && c <= '9'; }

/// True if a field or an enumerator may have this name: letters, digits and '_', not beginning with
/// a digit.
constexpr bool IsIdentifier(std::string_view name) {
  if (name.empty() || name.size() > kMaxFieldName || IsDigit(name.front())) return false;
  return std::ranges::all_of(name, [](char c) { return IsLetter(c) || IsDigit(c) || c == '_'; });
}

/// True if `name` consists of identifiers joined by dots, as in "arm.JointState".
constexpr bool IsTypeName(std::string_view name) {
  if (name.size() > kMaxTypeName) return false;
  for (auto dot = name.find('.'); dot != std::string_view::npos; dot = name.find('.')) {
    if (!IsIdentifier(name.substr(0, dot))) return false;
    name.remove_prefix(dot + 1);
  }
  return IsIdentifier(name);
}

/// True if `text` is empty, or one printable line without spaces at its ends.
constexpr bool IsLine(std::string_view text, std::size_t most) {
  if (text.size() > most) return false;
  const auto printable = [](char c) { return static_cast<unsigned char>(c) >= ' ' && c != '\x7f'; };
  if (!std::ranges::all_of(text, printable)) return false;
  return text.empty() || (text.front() != ' ' && text.back() != ' ');
}
constexpr bool IsUnit(std::string_view unit) { return IsLine(unit, kMaxUnit); }
constexpr bool IsHelp(std::string_view help) { return IsLine(help, kMaxHelp); }
/// True if the limits are in order. False if a limit is not-a-number.
constexpr bool IsRange(const Range& range) { return range.lowest <= range.highest; }

template <std::size_t kCount>
constexpr bool AreDistinct(const std::array<std::string_view, kCount>& names) {
  for (std::size_t i = 0; i < kCount; ++i) {
    for (std::size_t j = i + 1; j < kCount; ++j) {
      if (names[i] == names[j]) return false;
    }
  }
  return true;
}

template <typename Enum>
constexpr bool FitsInt32(Enum value) {
  return static_cast<Enum>(static_cast<std::int32_t>(value)) == value;
}

}  // namespace payload

namespace payload {
/// Does not compile if a name, a unit, a help text or a range is wrong.
template <typename... Fields>
consteval auto CheckedDescription(std::string_view name, Fields... fields) {
  if (!payload::IsTypeName(name))
    throw ConfigurationError("the name of a type must be like arm.JointState");
  if (!(payload::IsIdentifier(fields.name) && ...)) {
    throw ConfigurationError("the name of a field may only have letters, digits and '_'");
  }
  if (!(payload::IsUnit(fields.unit) && ...)) {
    throw ConfigurationError("a unit must be a short printable text");
  }
  if (!(payload::IsHelp(fields.help) && ...)) {
    throw ConfigurationError("the help of a field must be one line of at most 200 characters");
  }
  if (!((!fields.range || payload::IsRange(*fields.range)) && ...)) {
    throw ConfigurationError("the first number of a range must be the lowest");
  }
  if (!payload::AreDistinct(std::array<std::string_view, sizeof...(fields)>{fields.name...})) {
    throw ConfigurationError("two fields have the same name");
  }
  return Description<Fields...>{name, {{fields}...}};
}

template <typename T, std::size_t... kIndices, typename... Names>
consteval auto DescribeByPosition(std::string_view name, std::index_sequence<kIndices...>,
                                  Names... names) {
  return CheckedDescription(name, FieldByPosition<T, kIndices, sizeof...(names)>{
                                      names.name, names.unit, names.help, names.range}...);
}
}  // namespace payload

/// Describes a structure. A wrong description does not compile.
template <typename... Owner, typename... Member>
consteval auto Describe(std::string_view name, Field<Owner, Member>... fields) {
  return payload::CheckedDescription(name, fields...);
}

/// Describes an aggregate without a base class: the names of all of its members, in their order.
/// The result is the same as with Field, but the compiler cannot notice names in a wrong order.
///
///     Describe<arm::JointState>("arm.JointState", "position in rad", "velocity in rad/s")
template <typename T, std::convertible_to<FieldName>... Names>
consteval auto Describe(std::string_view name, const Names&... names) {
  constexpr std::size_t kCount = sizeof...(names);
  static_assert(std::is_aggregate_v<T>,
                "given a class that is not an aggregate; describe it with "
                "Field{\"name\", &T::member} for each member");
  static_assert(kCount <= payload::kMaxFields,
                "given more than 24 names; describe T with Field{\"name\", &T::member} for each "
                "member");
  if constexpr (std::is_aggregate_v<T> && kCount <= payload::kMaxFields) {
    static_assert(payload::kHasAtLeast<T, kCount>,
                  "given more names than T has members; expected one name for each member");
    static_assert(!payload::kHasAtLeast<T, kCount + 1>,
                  "given fewer names than T has members; expected one name for each member, and "
                  "std::array instead of a C array");
    if constexpr (payload::kHasAtLeast<T, kCount> && !payload::kHasAtLeast<T, kCount + 1>) {
      return payload::DescribeByPosition<T>(name, std::make_index_sequence<kCount>(),
                                            FieldName(names)...);
    } else {
      return NotDescribed{};
    }
  } else {
    return NotDescribed{};
  }
}

/// Describes an enum. On the wire it is an int32; a value without a name cannot be decoded.
template <typename Enum, typename... More>
consteval auto DescribeEnum(std::string_view name, Enumerator<Enum> first, More... more) {
  using All = std::array<Enumerator<Enum>, 1 + sizeof...(more)>;
  if (!payload::IsTypeName(name))
    throw ConfigurationError("the name of a type must be like arm.Mode");
  const EnumDescription<Enum, 1 + sizeof...(more)> description{name, All{first, more...}};
  for (std::size_t i = 0; i < description.enumerators.size(); ++i) {
    const auto& one = description.enumerators[i];
    if (!payload::IsIdentifier(one.name))
      throw ConfigurationError("the name of an enumerator is invalid");
    if (!payload::FitsInt32(one.value)) throw ConfigurationError("an enumerator exceeds int32");
    for (std::size_t j = 0; j < i; ++j) {
      const auto& other = description.enumerators[j];
      if (one.name == other.name || one.value == other.value) {
        throw ConfigurationError("two enumerators have the same name or the same value");
      }
    }
  }
  return description;
}

}  // namespace tendon
