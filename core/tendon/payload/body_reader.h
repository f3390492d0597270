#pragma once

#include <tendon/payload/cdr.h>
#include <tendon/payload/schema.h>

#include <cstddef>
#include <cstdint>

/// Reads an encoded body with the help of its schema. As in Decode(), the depth of the schema
/// limits the recursion, and the number of bytes limits the loops.
namespace tendon::payload {

/// Calls `visit(zero)`, where `zero` has the C++ type of a number of this kind. Returns the result
/// of `visit`.
template <typename Visitor>
auto WithNumber(Schema::Kind kind, Visitor&& visit) {
  switch (kind) {
    case Schema::Kind::kBool:
      return visit(false);
    case Schema::Kind::kInt8:
      return visit(std::int8_t{0});
    case Schema::Kind::kUint8:
      return visit(std::uint8_t{0});
    case Schema::Kind::kInt16:
      return visit(std::int16_t{0});
    case Schema::Kind::kUint16:
      return visit(std::uint16_t{0});
    case Schema::Kind::kUint32:
      return visit(std::uint32_t{0});
    case Schema::Kind::kInt64:
      return visit(std::int64_t{0});
    case Schema::Kind::kUint64:
      return visit(std::uint64_t{0});
    case Schema::Kind::kFloat32:
      return visit(float{0});
    case Schema::Kind::kFloat64:
      return visit(double{0});
    default:
      return visit(std::int32_t{0});  // also for enums
  }
}

[[nodiscard]] inline bool ReadDuration(CdrReader& reader, CdrDuration& duration) {
  return reader.Read(duration.sec) && reader.Read(duration.nanosec) &&
         duration.nanosec < 1'000'000'000;
}

/// Skips `count` consecutive values.
[[nodiscard]] bool SkipValues(const Schema& schema, std::size_t count, CdrReader& reader);

/// Sets `count` to the number of elements of a list. The number is read from the body for a
/// sequence, and taken from the schema for an array.
[[nodiscard]] inline bool ReadElementCount(const Schema& list, CdrReader& reader,
                                           std::uint32_t& count) {
  if (list.kind() == Schema::Kind::kSequence) {
    return reader.ReadLength(count, list.element().minimum_size());
  }
  count = list.length();
  return true;
}

}  // namespace tendon::payload
