#include <tendon/gcm/lifecycle/parameters.h>

#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/payload/json.h>
#include <tendon/payload/json/strict_json.h>
#include <tendon/payload/json/typed_value.h>
#include <tendon/payload/schema.h>
#include <tendon/payload/schema/values_text.h>

#include <charconv>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace tendon {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The complete configuration of a component, and its type.
struct WholeConfiguration {
  Schema schema;
  OrderedJson given;  // the configuration, without fields that keep their default
  OrderedJson value;  // the configuration with the defaults
};

Result<WholeConfiguration> WholeOf(const ClassDescription& of, const std::string& configuration) {
  auto schema = Schema::Parse(of.configuration);
  if (!schema) return schema.error();
  if (schema->is_none()) {
    return Error{ErrorCode::kNotFound, "class '" + of.name + "' takes no configuration"};
  }
  const auto refuse = [&of](const std::string& why) {
    return Error{ErrorCode::kInvalid, "class '" + of.name + "' has a configuration that " + why};
  };
  const auto defaults = ParseOrderedJson(of.defaults);
  if (!defaults) return refuse("cannot be read: " + defaults.error().message);
  const auto given = ParseOrderedJson(configuration.empty() ? "{}" : configuration);
  if (!given) return refuse("cannot be read: " + given.error().message);
  if (!given->is_object() || !defaults->is_object()) return refuse("is not a JSON object");
  WholeConfiguration whole{*std::move(schema), *given, *defaults};
  whole.value.merge_patch(whole.given);
  return whole;
}

/// One part of a name such as "gain.x[2]": an element of a list if `index` is set, otherwise a
/// field.
struct Step {
  std::string field;
  std::optional<std::size_t> index = std::nullopt;
};

Result<std::vector<Step>> StepsOf(const std::string& name) {
  std::vector<Step> steps;
  std::string_view rest = name;
  const Error wrong{ErrorCode::kInvalid,
                    Quoted(name, 64) +
                        " does not name a parameter: expected a name such as gain, "
                        "gain.x or gain[2]"};
  while (!rest.empty()) {
    if (rest.front() == '[') {
      const auto end = rest.find(']');
      std::size_t index = 0;
      if (end == rest.npos || steps.empty()) return wrong;
      const auto read = std::from_chars(rest.data() + 1, rest.data() + end, index);
      if (read.ec != std::errc() || read.ptr != rest.data() + end) return wrong;
      steps.push_back({.field = {}, .index = index});
      rest.remove_prefix(end + 1);
      continue;
    }
    if (!steps.empty()) {
      if (rest.front() != '.') return wrong;
      rest.remove_prefix(1);
    }
    const std::string_view field = rest.substr(0, rest.find_first_of(".["));
    if (field.empty()) return wrong;
    steps.push_back({.field = std::string(field)});
    rest.remove_prefix(field.size());
  }
  if (steps.empty()) return wrong;
  return steps;
}

Error NoField(const Schema& structure, const std::string& field, const std::string& where) {
  std::vector<std::string> names;
  for (const Schema::Field& one : structure.fields()) names.push_back(one.name);
  const std::string at = where.empty() ? "" : " in '" + where + "'";
  std::string message = "no parameter " + Quoted(field, 64) + at;
  if (const std::string near = DidYouMean(field, names); !near.empty()) {
    return {ErrorCode::kNotFound, message + near};
  }
  message += "; there is";
  for (std::size_t i = 0; i < names.size(); ++i) message += (i == 0 ? " " : ", ") + names[i];
  return {ErrorCode::kNotFound, message};
}

/// A part of a configuration.
struct Part {
  Schema schema;
  OrderedJson* value = nullptr;
};

/// Returns the field or element of `part` that `step` names. `where` is the name of `part`, for
/// errors.
Result<Part> Enter(const Part& part, const Step& step, const std::string& where) {
  using Kind = Schema::Kind;
  const Schema& schema = part.schema;
  if (step.index) {
    if (schema.kind() != Kind::kArray && schema.kind() != Kind::kSequence) {
      return Error{ErrorCode::kNotFound,
                   "'" + where + "' is " + schema.TypeName() + " and has no elements"};
    }
    if (*step.index < part.value->size()) {
      return Part{schema.element(), &(*part.value)[*step.index]};
    }
    return Error{ErrorCode::kNotFound, "'" + where + "' has " + std::to_string(part.value->size()) +
                                           " elements, numbered from 0; there is no element " +
                                           std::to_string(*step.index)};
  }
  if (schema.kind() != Kind::kStructure) {
    return Error{ErrorCode::kNotFound,
                 "'" + where + "' is " + schema.TypeName() + " and has no fields"};
  }
  for (const Schema::Field& field : schema.fields()) {
    if (field.name == step.field) return Part{field.schema, &(*part.value)[field.name]};
  }
  return NoField(schema, step.field, where);
}

Result<Part> Find(WholeConfiguration& whole, const std::vector<Step>& steps) {
  Part part{whole.schema, &whole.value};
  std::string where;
  for (const Step& step : steps) {
    const auto next = Enter(part, step, where);
    if (!next) return next.error();
    part = *next;
    where += step.index ? "[" + std::to_string(*step.index) + "]"
                        : (where.empty() ? "" : ".") + step.field;
  }
  return part;
}

/// Copies only the changed field from `value` to `given`. If an element of a list has changed,
/// copies the whole list.
void CopyChange(WholeConfiguration& whole, const std::vector<Step>& steps) {
  OrderedJson* given = &whole.given;
  const OrderedJson* value = &whole.value;
  for (const Step& step : steps) {
    if (step.index) break;
    if (!given->is_object()) *given = OrderedJson::object();
    given = &(*given)[step.field];
    value = &value->at(step.field);
  }
  *given = *value;
}

void AddLeaves(const std::string& name, const Schema::Field& field, const OrderedJson& value,
               std::vector<Parameter>& all) {
  if (field.schema.kind() == Schema::Kind::kStructure && value.is_object()) {
    for (const Schema::Field& inner : field.schema.fields()) {
      if (!value.contains(inner.name)) continue;
      AddLeaves(name + "." + inner.name, inner, value.at(inner.name), all);
    }
    return;
  }
  all.push_back({.name = name,
                 .type = field.schema.TypeName(),
                 .unit = field.unit,
                 .values = ValuesText(field),
                 .help = field.help,
                 .value = value.dump()});
}

}  // namespace

Result<std::vector<Parameter>> ParametersOf(const ClassDescription& of,
                                            const std::string& configuration) {
  const auto whole = WholeOf(of, configuration);
  if (!whole) return whole.error();
  std::vector<Parameter> all;
  for (const Schema::Field& field : whole->schema.fields()) {
    if (!whole->value.contains(field.name)) continue;
    AddLeaves(field.name, field, whole->value.at(field.name), all);
  }
  return all;
}

Result<std::vector<Parameter>> ParametersAt(const ClassDescription& of,
                                            const std::string& configuration,
                                            const std::string& name) {
  auto whole = WholeOf(of, configuration);
  if (!whole) return whole.error();
  const auto steps = StepsOf(name);
  if (!steps) return steps.error();
  const auto part = Find(*whole, *steps);
  if (!part) return part.error();
  const auto all = ParametersOf(of, configuration);
  if (!all) return all.error();
  std::vector<Parameter> found;
  for (const Parameter& one : *all) {
    if (one.name == name || one.name.starts_with(name + ".")) found.push_back(one);
    if (!name.starts_with(one.name + "[")) continue;
    found.push_back(one);  // `name` refers to an element of this parameter
    found.back().name = name;
    found.back().type = part->schema.TypeName();
    found.back().value = part->value->dump();
  }
  return found;
}

Result<ChangedParameter> ChangeParameter(const ClassDescription& of,
                                         const std::string& configuration, const std::string& name,
                                         const std::string& value) {
  auto whole = WholeOf(of, configuration);
  if (!whole) return whole.error();
  const auto steps = StepsOf(name);
  if (!steps) return steps.error();
  const auto part = Find(*whole, *steps);
  if (!part) return part.error();
  auto wanted = TypedValue(part->schema, name, value);
  if (!wanted) return wanted.error();
  ChangedParameter changed{.former = part->value->dump(), .value = {}, .configuration = {}};
  *part->value = *std::move(wanted);
  const auto body = FromJson(whole->schema, whole->value.dump());
  if (!body) return body.error();
  changed.value = part->value->dump();
  CopyChange(*whole, *steps);
  changed.configuration = whole->given.dump();
  return changed;
}

}  // namespace tendon
