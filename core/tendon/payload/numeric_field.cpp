#include <tendon/payload/numeric_field.h>

#include <tendon/base/name.h>
#include <tendon/payload/body_reader.h>

#include <charconv>

namespace tendon {
namespace {

using payload::CdrReader;

bool IsNumeric(const Schema& schema) {
  return schema.is_number() || schema.kind() == Schema::Kind::kEnum ||
         schema.kind() == Schema::Kind::kDuration;
}

bool IsList(const Schema& schema) {
  return schema.kind() == Schema::Kind::kArray || schema.kind() == Schema::Kind::kSequence;
}

std::string UnitOf(const Schema& number, const std::string& unit) {
  return unit.empty() && number.kind() == Schema::Kind::kDuration ? "s" : unit;
}

/// Reads the next value as a number.
std::optional<NumericValue> ReadNumber(const Schema& schema, CdrReader& reader) {
  if (schema.kind() == Schema::Kind::kDuration) {
    payload::CdrDuration duration;
    if (!payload::ReadDuration(reader, duration)) return std::nullopt;
    return NumericValue(duration);
  }
  return payload::WithNumber(schema.kind(), [&](auto number) -> std::optional<NumericValue> {
    if (!reader.Read(number)) return std::nullopt;
    return NumericValue(number);
  });
}

/// Walks a schema, and a body if there is one, in wire order and lists each number.
class Lister {
 public:
  Lister(const Schema& root, CdrReader* reader) : root_(root), reader_(reader) {}

  /// Adds all numbers in a value of this schema. Returns false if the body cannot be decoded.
  bool Visit(const Schema& schema, const std::string& unit) {
    if (is_full()) return true;
    if (IsNumeric(schema)) return VisitNumber(schema, unit);
    if (IsList(schema)) return VisitList(schema, unit);
    if (schema.kind() == Schema::Kind::kString || schema.is_none()) {
      if (position_ && schema.is_none()) {
        ++*position_;
      } else {
        position_.reset();
      }
      return reader_ == nullptr || payload::SkipValues(schema, 1, *reader_);
    }
    for (std::uint32_t i = 0; i < schema.fields().size(); ++i) {
      const Schema::Field& field = schema.fields()[i];
      const bool good = Inside("." + field.name, i, [&] {
        return Visit(field.schema, field.unit.empty() ? unit : field.unit);
      });
      if (!good) return false;
    }
    return true;
  }

  [[nodiscard]] bool is_full() const { return fields_.size() == kMaxNumericFields; }
  std::vector<NumericField> Take() { return std::move(fields_); }

 private:
  bool VisitNumber(const Schema& schema, const std::string& unit) {
    const std::size_t size = schema.minimum_size();
    const bool is_duration = schema.kind() == Schema::Kind::kDuration;
    if (position_) position_ = payload::AlignUp(*position_, is_duration ? 4 : size);
    fields_.push_back({path_, UnitOf(schema, unit), schema, position_, root_, route_});
    if (position_) *position_ += size;
    return reader_ == nullptr || ReadNumber(schema, *reader_);
  }

  bool VisitList(const Schema& list, const std::string& unit) {
    if (list.kind() == Schema::Kind::kSequence) {
      position_.reset();
      if (reader_ == nullptr) return true;
    }
    std::uint32_t count = 0;
    if (reader_ == nullptr) {
      count = list.length();
    } else if (!payload::ReadElementCount(list, *reader_, count)) {
      return false;
    }
    const std::size_t fields_before = fields_.size();
    for (std::uint32_t i = 0; i < count && !is_full(); ++i) {
      const bool good =
          Inside("[" + std::to_string(i) + "]", i, [&] { return Visit(list.element(), unit); });
      if (!good) return false;
      if (reader_ == nullptr && fields_.size() == fields_before) {
        // The elements have no numbers. The position of the next value stays known only if all
        // elements are None, because each None has one byte.
        if (position_) *position_ += (count - 1) * list.element().minimum_size();
        break;
      }
    }
    return true;
  }

  template <typename Action>
  bool Inside(const std::string& step, std::uint32_t index, Action action) {
    const std::size_t size = path_.size();
    path_ += step;
    route_.push_back(index);
    const bool good = action();
    route_.pop_back();
    path_.resize(size);
    return good;
  }

  const Schema& root_;
  CdrReader* reader_;
  std::optional<std::size_t> position_ = 0;
  std::string path_;
  std::vector<std::uint32_t> route_;
  std::vector<NumericField> fields_;
};

/// Follows a path through a schema, step by step.
class Finder {
 public:
  Finder(const Schema& root, std::string_view path) : rest_(path) {
    field_.root = root;
    field_.schema = root;
  }

  Result<NumericField> Find() {
    while (!rest_.empty()) {
      const auto step = rest_.front() == '[' ? TakeElement() : TakeField();
      if (!step) return step.error();
    }
    if (!IsNumeric(field_.schema)) {
      return NotFound("'" + field_.path + "' is " + field_.schema.TypeName() + ", not one number");
    }
    field_.unit = UnitOf(field_.schema, field_.unit);
    return std::move(field_);
  }

 private:
  Result<void> TakeField() {
    rest_.remove_prefix(rest_.front() == '.' ? 1 : 0);
    const std::string name(rest_.substr(0, rest_.find_first_of(".[")));
    rest_.remove_prefix(name.size());
    std::vector<std::string> names;
    const auto& fields = field_.schema.fields();
    for (std::uint32_t i = 0; i < fields.size(); ++i) {
      if (fields[i].name != name) {
        names.push_back(fields[i].name);
        continue;
      }
      field_.path += "." + name;
      if (!fields[i].unit.empty()) field_.unit = fields[i].unit;
      Enter(i, Schema(fields[i].schema));
      return {};
    }
    return NotFound(field_.schema.TypeName() + " has no field '" + name + "'" +
                    DidYouMean(name, names));
  }

  Result<void> TakeElement() {
    std::uint32_t index = 0;
    const char* const end = rest_.data() + rest_.size();
    const auto [last, code] = std::from_chars(rest_.data() + 1, end, index);
    if (code != std::errc{} || last == end || *last != ']') {
      return NotFound("'" + std::string(rest_) + "' does not begin with an index, like [0]");
    }
    rest_ = std::string_view(last + 1, static_cast<std::size_t>(end - last - 1));
    const Schema& list = field_.schema;
    if (!IsList(list)) return NotFound(list.TypeName() + " has no elements");
    if (list.kind() == Schema::Kind::kArray && index >= list.length()) {
      return NotFound("[" + std::to_string(index) + "] is not in " + list.TypeName());
    }
    field_.path += "[" + std::to_string(index) + "]";
    Enter(index, Schema(list.element()));
    return {};
  }

  void Enter(std::uint32_t index, Schema schema) {
    field_.route.push_back(index);
    field_.schema = std::move(schema);
  }

  static Error NotFound(std::string message) { return {ErrorCode::kNotFound, std::move(message)}; }

  std::string_view rest_;
  NumericField field_;
};

/// Moves the reader to the value at the end of the route.
bool Follow(const NumericField& field, CdrReader& reader) {
  const Schema* schema = &field.root;
  for (const std::uint32_t index : field.route) {
    if (IsList(*schema)) {
      std::uint32_t count = 0;
      if (!payload::ReadElementCount(*schema, reader, count) || index >= count) return false;
      schema = &schema->element();
      if (!payload::SkipValues(*schema, index, reader)) return false;
    } else {
      for (std::uint32_t i = 0; i < index; ++i) {
        if (!payload::SkipValues(schema->fields()[i].schema, 1, reader)) return false;
      }
      schema = &schema->fields()[index].schema;
    }
  }
  return true;
}

}  // namespace

std::vector<NumericField> NumericFields(const Schema& schema) {
  Lister lister(schema, nullptr);
  lister.Visit(schema, "");
  return lister.Take();
}

std::vector<NumericField> NumericFields(const Schema& schema, std::span<const std::byte> body) {
  CdrReader reader(body);
  Lister lister(schema, &reader);
  if (!lister.Visit(schema, "") || !(lister.is_full() || reader.AtEnd())) return {};
  return lister.Take();
}

Result<NumericField> FindNumericField(const Schema& schema, std::string_view path) {
  auto found = Finder(schema, path).Find();
  if (!found) return found;
  for (const NumericField& field : NumericFields(schema)) {
    if (field.path == found->path) found->offset = field.offset;
  }
  return found;
}

std::optional<NumericValue> ReadExactly(const NumericField& field,
                                        std::span<const std::byte> body) {
  if (field.offset) {
    if (*field.offset > body.size()) return std::nullopt;
    CdrReader reader(body.subspan(*field.offset));
    return ReadNumber(field.schema, reader);
  }
  CdrReader reader(body);
  if (!Follow(field, reader)) return std::nullopt;
  return ReadNumber(field.schema, reader);
}

std::optional<double> ReadAsDouble(const NumericField& field, std::span<const std::byte> body) {
  const auto value = ReadExactly(field, body);
  return value ? std::optional(value->real()) : std::nullopt;
}

}  // namespace tendon
