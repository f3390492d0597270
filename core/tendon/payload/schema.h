#pragma once

#include <tendon/base/result.h>
#include <tendon/payload/encoded_size.h>
#include <tendon/payload/payload.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace tendon {

struct Fingerprint;

/// Describes the type of a payload at run time, for programs that were built without this type.
/// Immutable; threads may share it, and a copy only increments a reference count.
class Schema {
 public:
  enum class Kind : std::int32_t {
    kBool,
    kInt8,
    kUint8,
    kInt16,
    kUint16,
    kInt32,
    kUint32,
    kInt64,
    kUint64,
    kFloat32,
    kFloat64,
    kString,
    kDuration,  ///< int32 seconds, uint32 nanoseconds
    kEnum,      ///< int32 with a name for each value
    kArray,     ///< of fixed length
    kSequence,  ///< of varying length
    kStructure,
  };
  struct Field;
  /// One named value of an enum.
  struct Enumerator {
    std::string name;
    std::int32_t value = 0;

    bool operator==(const Enumerator&) const = default;
  };

  /// The schema of None.
  Schema();
  /// A number, a string or a duration.
  explicit Schema(Kind simple);
  /// Names, lengths and shapes are not checked; use Parse() for untrusted text.
  static Schema Enum(std::string name, std::vector<Enumerator> enumerators);
  static Schema Array(Schema element, std::uint32_t length);
  static Schema Sequence(Schema element);
  static Schema Structure(std::string name, std::vector<Field> fields);

  [[nodiscard]] Kind kind() const;
  /// The name of a structure or an enum; empty for other kinds.
  [[nodiscard]] const std::string& name() const;
  /// The fields of a structure, in wire order; empty for all other kinds.
  [[nodiscard]] const std::vector<Field>& fields() const;
  [[nodiscard]] const std::vector<Enumerator>& enumerators() const;
  /// The type of the elements of an array or a sequence.
  [[nodiscard]] const Schema& element() const;
  /// The number of elements of an array.
  [[nodiscard]] std::uint32_t length() const;

  /// True for bool, an integer, a float or a double.
  [[nodiscard]] bool is_number() const { return kind() <= Kind::kFloat64; }
  /// True for a structure without fields. It has no content, but takes one byte on the wire.
  [[nodiscard]] bool is_none() const { return kind() == Kind::kStructure && fields().empty(); }
  /// The fewest bytes that a value takes on the wire; at least 1.
  [[nodiscard]] std::size_t minimum_size() const;
  /// True if a field of this type can have a range: integers, floats, durations, or lists of these.
  [[nodiscard]] bool holds_numbers() const;
  /// One word for tables and errors: "arm.JointState", "float64[7]", "string[]".
  [[nodiscard]] std::string TypeName() const;

  /// Returns the canonical text. It shows exactly the properties that must be equal at both ends of
  /// a connection.
  ///
  ///     struct arm.JointState {
  ///       position: float64[7] in rad
  ///       mode: enum arm.Mode {
  ///         off = 0
  ///       }
  ///     }
  [[nodiscard]] std::string Text() const;
  /// Like Text(), but adds the help and the range of each field in lines before the field, for
  /// people and forms. These lines do not change the fingerprint of the parsed schema.
  ///
  ///       # Of the fastest joint.
  ///       @ 0 to 2.5
  ///       speed: float64 in rad/s
  [[nodiscard]] std::string TextWithHelp() const;
  /// Reads the result of Text() or TextWithHelp(), which may come from an untrusted source. Limits:
  /// 1 MiB of text, 64 levels, a minimum_size() of 2 GiB. The error names line and column.
  static Result<Schema> Parse(std::string_view text);
  /// Computes the fingerprint from the text at each call. Needs fingerprint.h.
  [[nodiscard]] Fingerprint fingerprint() const;

  /// True if the canonical texts are equal.
  bool operator==(const Schema& other) const;

 private:
  struct Node;
  explicit Schema(std::shared_ptr<const Node> node);

  std::shared_ptr<const Node> node_;
};

/// A field of a structure. `unit` is empty if the field has no unit. `unit` and `range` apply to
/// all numbers in `schema`.
struct Schema::Field {
  std::string name;
  std::string unit;
  Schema schema;
  std::string help = {};
  std::optional<Range> range = {};
};

/// Returns "bool", "int8" ... "float64", "string", "duration", "enum", "array", "sequence",
/// "struct".
[[nodiscard]] std::string_view ToString(Schema::Kind kind);

/// Returns the definition of a ROS 2 message for this schema. Definitions of nested messages are
/// appended as in MCAP. An enum becomes an int32 with constants. A schema that is not a structure
/// becomes a message with the single field `data`.
[[nodiscard]] std::string RosMessage(const Schema& schema);
/// Returns the name of the message that RosMessage() defines: "arm/msg/JointState" for a structure.
[[nodiscard]] std::string RosTypeName(const Schema& schema);

/// Returns the first difference between two types, or nothing if they are equal: "position of
/// arm.JointState: float64[7] in rad needed, float64[7] in deg offered".
[[nodiscard]] std::optional<std::string> FirstDifference(const Schema& needed,
                                                         const Schema& offered);

namespace payload {

template <typename T>
consteval Schema::Kind KindOf() {
  using Kind = Schema::Kind;
  if constexpr (std::same_as<T, bool>) {
    return Kind::kBool;
  } else if constexpr (std::same_as<T, std::byte>) {
    return Kind::kUint8;
  } else if constexpr (std::is_floating_point_v<T>) {
    return sizeof(T) == 4 ? Kind::kFloat32 : Kind::kFloat64;
  } else {
    constexpr bool kSigned = std::is_signed_v<T>;
    switch (sizeof(T)) {
      case 1:
        return kSigned ? Kind::kInt8 : Kind::kUint8;
      case 2:
        return kSigned ? Kind::kInt16 : Kind::kUint16;
      case 4:
        return kSigned ? Kind::kInt32 : Kind::kUint32;
      default:
        return kSigned ? Kind::kInt64 : Kind::kUint64;
    }
  }
}

template <typename T>
Schema BuildSchema();

}  // namespace payload

/// Returns the schema of a type, which is built at the first call. Thread-safe.
template <Payload T>
[[nodiscard]] const Schema& SchemaOf() {
  static const Schema schema = payload::BuildSchema<T>();
  return schema;
}

template <typename T>
Schema payload::BuildSchema() {
  if constexpr (Number<T>) {
    return Schema(KindOf<T>());
  } else if constexpr (NamedEnum<T>) {
    std::vector<Schema::Enumerator> enumerators;
    for (const auto& one : kPayload<T>.enumerators) {
      enumerators.push_back({std::string(one.name), static_cast<std::int32_t>(one.value)});
    }
    return Schema::Enum(std::string(kPayload<T>.name), std::move(enumerators));
  } else if constexpr (payload::Enum<T>) {
    return Schema(Schema::Kind::kInt32);
  } else if constexpr (Text<T>) {
    return Schema(Schema::Kind::kString);
  } else if constexpr (TimeSpan<T>) {
    return Schema(Schema::Kind::kDuration);
  } else if constexpr (payload::Array<T>) {
    return Schema::Array(SchemaOf<ElementOf<T>>(), std::uint32_t{ArrayTraits<T>::kLength});
  } else if constexpr (payload::Sequence<T>) {
    return Schema::Sequence(SchemaOf<ItemOf<T>>());
  } else if constexpr (Substituted<T>) {
    return SchemaOf<SubstituteOf<T>>();
  } else {
    std::vector<Schema::Field> fields;
    WithFields<T>([&](const auto&... field) {
      (fields.push_back({std::string(field.name), std::string(field.unit),
                         SchemaOf<TypeOf<decltype(field)>>(), std::string(field.help),
                         field.range}),
       ...);
    });
    return Schema::Structure(std::string(kPayload<T>.name), std::move(fields));
  }
}

}  // namespace tendon
