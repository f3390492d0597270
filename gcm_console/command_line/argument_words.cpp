#include <gcm_console/command_line/argument_words.h>

#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/payload/json/typed_value.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>

namespace console {
namespace {

using tendon::Error;
using tendon::ErrorCode;
using tendon::Result;
using tendon::Schema;

std::vector<std::string> NamesOf(const Schema& structure) {
  std::vector<std::string> names;
  for (const Schema::Field& field : structure.fields()) names.push_back(field.name);
  return names;
}

/// Returns the fields of a structure: "arm.JointGoal has position, duration".
std::string FieldsText(const Schema& structure) {
  std::string text = structure.TypeName() + " has ";
  for (const std::string& name : NamesOf(structure)) {
    text += (text.ends_with(' ') ? "" : ", ") + name;
  }
  return text;
}

/// Returns the name before the '=' of a word, if it can be the name of a field.
std::optional<std::string> NameIn(const std::string& word) {
  const std::size_t end = word.find('=');
  if (end == std::string::npos || end == 0) return std::nullopt;
  const auto is_of_name = [](unsigned char letter) {
    return std::isalnum(letter) != 0 || letter == '_';
  };
  const auto equals = word.begin() + static_cast<std::ptrdiff_t>(end);
  if (!std::all_of(word.begin(), equals, is_of_name)) return std::nullopt;
  return word.substr(0, end);
}

/// Assigns words to the fields of a structure, one after another.
class FieldsByWords {
 public:
  explicit FieldsByWords(const Schema& schema) : schema_(schema) {}

  Result<void> Take(const std::string& word) {
    const auto name = NameIn(word);
    const Schema::Field* field = name ? Find(*name) : NextFree();
    if (field == nullptr && name) return NoField(*name);
    if (field == nullptr) {
      return Error{ErrorCode::kInvalid,
                   tendon::Quoted(word, 64) + " is one word too many: " + FieldsText(schema_)};
    }
    if (!given_.insert(field->name).second) {
      return Error{ErrorCode::kInvalid, field->name + " is given twice: leave out one of the two"};
    }
    auto value =
        tendon::TypedValue(field->schema, field->name, name ? word.substr(name->size() + 1) : word);
    if (!value) return value.error();
    value_[field->name] = *std::move(value);
    return {};
  }
  /// Returns the next field without a word; null if all fields have one.
  [[nodiscard]] const Schema::Field* NextFree() const {
    for (const Schema::Field& field : schema_.fields()) {
      if (!IsGiven(field)) return &field;
    }
    return nullptr;
  }
  [[nodiscard]] bool IsGiven(const Schema::Field& field) const {
    return given_.contains(field.name);
  }
  [[nodiscard]] std::string json() const { return value_.dump(); }

 private:
  [[nodiscard]] const Schema::Field* Find(const std::string& name) const {
    const auto& fields = schema_.fields();
    const auto found = std::ranges::find(fields, name, &Schema::Field::name);
    return found == fields.end() ? nullptr : &*found;
  }
  [[nodiscard]] Error NoField(const std::string& name) const {
    const std::string near = tendon::DidYouMean(name, NamesOf(schema_));
    return {ErrorCode::kInvalid,
            "no field '" + name + "'" + (near.empty() ? "; " + FieldsText(schema_) : near)};
  }

  const Schema& schema_;
  nlohmann::ordered_json value_ = nlohmann::ordered_json::object();
  std::set<std::string> given_;
};

Result<std::string> StructureOf(const Schema& schema, const std::vector<std::string>& words) {
  FieldsByWords fields(schema);
  for (const std::string& word : words) {
    if (auto taken = fields.Take(word); !taken) return taken.error();
  }
  if (const Schema::Field* missing = fields.NextFree()) {
    return Error{ErrorCode::kInvalid, missing->name + " is missing: " + FieldsText(schema)};
  }
  return fields.json();
}

Result<std::string> ValueOf(const Schema& schema, const std::vector<std::string>& words) {
  if (words.size() > 1) {
    return Error{ErrorCode::kInvalid, tendon::Quoted(words[1], 64) +
                                          " is one word too many: expected one value of type " +
                                          schema.TypeName()};
  }
  const auto value = tendon::TypedValue(schema, "the argument", words[0]);
  if (!value) return value.error();
  return value->dump();
}

}  // namespace

Result<std::string> ArgumentOf(const Schema& schema, const std::string& command,
                               const std::vector<std::string>& words) {
  const bool is_structure = schema.kind() == Schema::Kind::kStructure;
  if (is_structure && words.size() == 1 && words[0].starts_with('{')) return words[0];
  auto argument = is_structure ? StructureOf(schema, words) : ValueOf(schema, words);
  if (argument) return argument;
  return Error{argument.error().code, command + ": " + argument.error().message};
}

std::vector<std::string> ValuesOf(const Schema& schema) {
  if (schema.kind() == Schema::Kind::kBool) return {"false", "true"};
  std::vector<std::string> names;
  for (const Schema::Enumerator& one : schema.enumerators()) names.push_back(one.name);
  return names;
}

std::vector<std::string> NextWords(const Schema& schema, const std::vector<std::string>& words) {
  if (schema.kind() != Schema::Kind::kStructure) {
    return words.empty() ? ValuesOf(schema) : std::vector<std::string>();
  }
  if (!words.empty() && words[0].starts_with('{')) return {};  // all fields are in one JSON word
  FieldsByWords fields(schema);
  for (const std::string& word : words) {
    if (!fields.Take(word)) return {};
  }
  const Schema::Field* next = fields.NextFree();
  if (next == nullptr) return {};
  std::vector<std::string> all = ValuesOf(next->schema);
  for (const Schema::Field& field : schema.fields()) {
    if (fields.IsGiven(field)) continue;
    const std::string begin = field.name + "=";
    all.push_back(begin);
    for (const std::string& value : ValuesOf(field.schema)) all.push_back(begin + value);
  }
  return all;
}

}  // namespace console
