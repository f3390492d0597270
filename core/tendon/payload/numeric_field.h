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
  std::string unit;  ///< of the innermost field that has one; "s" for a duration without
  Schema schema;     ///< of the number: bool, integer, float, enum or duration
  /// Its offset in every body, in bytes; empty if a string or sequence comes before it.
  std::optional<std::size_t> offset;

  Schema root;                       ///< of the whole payload
  std::vector<std::uint32_t> route;  ///< from `root` on: indices of fields and elements
};

/// The largest number of listed fields.
constexpr std::size_t kMaxNumericFields = 16384;

/// All numbers of a schema, in wire order, without the elements of sequences, whose number varies.
[[nodiscard]] std::vector<NumericField> NumericFields(const Schema& schema);

/// All numbers of one value, including sequence elements. Empty if it cannot be decoded.
[[nodiscard]] std::vector<NumericField> NumericFields(const Schema& schema,
                                                      std::span<const std::byte> body);

/// The field of a path that a person types: ".cores[3].load". The path may name a sequence
/// element that does not exist now. The error says which part of the path the schema does not have.
[[nodiscard]] Result<NumericField> FindNumericField(const Schema& schema, std::string_view path);

/// The number in one body; empty if the body is too short or has no such element. Costs a load if
/// the field has an offset, otherwise a walk over all values before it; allocates nothing.
[[nodiscard]] std::optional<NumericValue> ReadExactly(const NumericField& field,
                                                      std::span<const std::byte> body);

/// The same as a double: rounds integers beyond 2^53; a bool is 0 or 1, an enum its value, a
/// duration in seconds.
[[nodiscard]] std::optional<double> ReadAsDouble(const NumericField& field,
                                                 std::span<const std::byte> body);

}  // namespace tendon
