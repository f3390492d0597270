#pragma once

#include <tendon/payload/numeric_value.h>
#include <tendon/payload/schema.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tendon {

/// One number inside a payload, which a plot can show as one curve.
struct NumericField {
  std::string path;  ///< ".position[0]", or empty if the payload itself is the number
  std::string unit;  ///< of the innermost field with a unit; "s" for other durations
  Schema schema;     ///< type of the number: bool, integer, float, enum or duration
  /// Offset of the number in every body, in bytes; empty if a string or sequence comes before it.
  std::optional<std::size_t> offset;

  Schema root;                       ///< type of the whole payload
  std::vector<std::uint32_t> route;  ///< indices of fields and elements, from `root` to the number
};

/// The maximum number of fields that NumericFields() lists.
constexpr std::size_t kMaxNumericFields = 16384;

/// Lists all numeric fields of a schema, in wire order. Leaves out the elements of sequences,
/// because the length of a sequence varies.
[[nodiscard]] std::vector<NumericField> NumericFields(const Schema& schema);

/// Lists all numeric fields of one value, including sequence elements. Empty if the value cannot be
/// decoded.
[[nodiscard]] std::vector<NumericField> NumericFields(const Schema& schema,
                                                      std::span<const std::byte> body);

/// Returns the numeric field at a path that a person types: ".cores[3].load". The path may name a
/// sequence element that does not exist now. The error says which part of the path the schema does
/// not have.
[[nodiscard]] Result<NumericField> FindNumericField(const Schema& schema, std::string_view path);

/// Reads the number from one body. Returns nothing if the body is too short or has no such element.
/// Costs one load if the field has an offset; otherwise skips all values before the number.
/// Allocates nothing.
[[nodiscard]] std::optional<NumericValue> ReadExactly(const NumericField& field,
                                                      std::span<const std::byte> body);

/// Like ReadExactly(), but returns a double. Integers beyond 2^53 are rounded. A bool becomes 0 or
/// 1, an enum becomes its value, and a duration becomes its seconds.
[[nodiscard]] std::optional<double> ReadAsDouble(const NumericField& field,
                                                 std::span<const std::byte> body);

}  // namespace tendon
