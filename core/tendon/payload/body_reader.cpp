#include <tendon/payload/body_reader.h>

#include <string_view>

namespace tendon::payload {
namespace {

bool SkipValue(const Schema& schema, CdrReader& reader) {
  switch (schema.kind()) {
    case Schema::Kind::kString: {
      std::string_view text;
      return reader.ReadString(text);
    }
    case Schema::Kind::kDuration:
      return reader.Skip(8, 4);
    case Schema::Kind::kArray:
    case Schema::Kind::kSequence: {
      std::uint32_t count = 0;
      return ReadElementCount(schema, reader, count) && SkipValues(schema.element(), count, reader);
    }
    case Schema::Kind::kStructure:
      if (schema.fields().empty()) return reader.Skip(1, 1);
      for (const Schema::Field& field : schema.fields()) {
        if (!SkipValue(field.schema, reader)) return false;
      }
      return true;
    default:
      return SkipValues(schema, 1, reader);
  }
}

}  // namespace

bool SkipValues(const Schema& schema, std::size_t count, CdrReader& reader) {
  if (count == 0) return true;
  if (schema.is_number() || schema.kind() == Schema::Kind::kEnum) {
    const std::size_t size = schema.minimum_size();
    return reader.Skip(count * size, size);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!SkipValue(schema, reader)) return false;
  }
  return true;
}

}  // namespace tendon::payload
