#include <tendon/manager/component_registry.h>

#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/payload/json/strict_json.h>

#include <exception>
#include <nlohmann/json.hpp>
#include <string>

namespace tendon {

void ComponentRegistry::AddFactory(ComponentClass added, Factory factory) {
  const std::string class_name = added.name;
  RequireName("class", class_name);
  if (!entries_.emplace(class_name, Entry{std::move(added), std::move(factory)}).second) {
    throw ConfigurationError("component class '" + class_name + "' is registered twice");
  }
}

Result<std::unique_ptr<Component>> ComponentRegistry::Create(
    const std::string& class_name, const std::string& name,
    const std::string& configuration_json) const {
  const auto entry = entries_.find(class_name);
  if (entry == entries_.end()) {
    const auto known = class_names();
    return Error{ErrorCode::kNotFound,
                 "no component class '" + class_name + "'" + DidYouMean(class_name, known)};
  }
  const std::string what = "component '" + name + "' (class " + class_name + "): ";
  try {
    auto component = entry->second.factory(name, configuration_json);
    if (component) return component;
    return Error{component.error().code, what + component.error().message};
  } catch (...) {
    return Error{ErrorCode::kFailed,
                 what + "its constructor failed: " + ReasonOf(std::current_exception())};
  }
}

std::vector<ComponentClass> ComponentRegistry::classes() const {
  std::vector<ComponentClass> all;
  for (const auto& [name, entry] : entries_) all.push_back(entry.description);
  return all;
}

std::vector<std::string> ComponentRegistry::class_names() const {
  std::vector<std::string> names;
  for (const auto& [name, entry] : entries_) names.push_back(name);
  return names;
}

Result<std::string> ComponentRegistry::MergeConfiguration(const std::string& defaults,
                                                          const std::string& json) {
  if (json.empty()) return defaults;
  auto merged = ParseStrictJson(defaults);
  if (!merged) return merged.error();
  const auto given = ParseStrictJson(json);
  if (!given) {
    return Error{ErrorCode::kInvalid,
                 "its configuration is not valid JSON: " + given.error().message};
  }
  if (!given->is_object()) {
    return Error{ErrorCode::kInvalid,
                 "its configuration must be a JSON object, got " + Printable(json, 64)};
  }
  merged->merge_patch(*given);
  return merged->dump();
}

}  // namespace tendon
