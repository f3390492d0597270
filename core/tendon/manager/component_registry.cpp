#include <tendon/base/name.h>
#include <tendon/manager/component_registry.h>

#include <nlohmann/json.hpp>

namespace tendon {

void ComponentRegistry::AddFactory(std::string class_name, Factory factory) {
  RequireName("class", class_name);
  if (!factories_.emplace(class_name, std::move(factory)).second) {
    throw ConfigurationError("component class '" + class_name + "' is registered twice");
  }
}

Result<std::unique_ptr<Component>> ComponentRegistry::Create(
    const std::string& class_name, const std::string& name,
    const std::string& configuration_json) const {
  const auto factory = factories_.find(class_name);
  if (factory == factories_.end()) {
    const auto known = class_names();
    return Error{ErrorCode::kNotFound,
                 "no component class '" + class_name + "'" + DidYouMean(class_name, known)};
  }
  const std::string what = "component '" + name + "' (class " + class_name + "): ";
  try {
    auto component = factory->second(name, configuration_json);
    if (component) return component;
    return Error{component.error().code, what + component.error().message};
  } catch (const std::exception& error) {
    return Error{ErrorCode::kFailed, what + "its constructor failed: " + error.what()};
  } catch (...) {
    return Error{ErrorCode::kFailed, what + "its constructor threw no std::exception"};
  }
}

std::vector<std::string> ComponentRegistry::class_names() const {
  std::vector<std::string> names;
  for (const auto& [name, factory] : factories_) names.push_back(name);
  return names;
}

Result<std::string> ComponentRegistry::MergeConfiguration(const std::string& defaults,
                                                          const std::string& json) {
  if (json.empty()) return defaults;
  auto merged = nlohmann::ordered_json::parse(defaults);
  const auto given = nlohmann::ordered_json::parse(json, nullptr, false);
  if (!given.is_object()) {
    return Error{ErrorCode::kInvalid, "its configuration must be a JSON object, got " + json};
  }
  merged.merge_patch(given);
  return merged.dump();
}

}  // namespace tendon
