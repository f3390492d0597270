#pragma once

#include <tendon/payload/json.h>
#include <tendon/task/component.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// The component classes that can be made by name. A plug-in adds its own in a function
///
///     extern "C" void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
///       registry.Add<arm::SimulatedArm>("SimulatedArm");
///     }
///
/// A class is made from its name, or from its name and its configuration: a described payload
/// called `Configuration` in the class, whose defaults hold for what the JSON leaves out.
class ComponentRegistry {
 public:
  using Factory = std::function<Result<std::unique_ptr<Component>>(const std::string& name,
                                                                   const std::string& json)>;

  /// ConfigurationError when the class is there already.
  template <std::derived_from<Component> T>
  void Add(std::string class_name) {
    AddFactory(std::move(class_name), [](const std::string& name, const std::string& json) {
      return Make<T>(name, json);
    });
  }
  void AddFactory(std::string class_name, Factory factory);

  /// Makes a component; errors name the class, and what its constructor said.
  Result<std::unique_ptr<Component>> Create(const std::string& class_name, const std::string& name,
                                            const std::string& configuration_json) const;

  [[nodiscard]] std::vector<std::string> class_names() const;

 private:
  template <typename T>
  static Result<std::unique_ptr<Component>> Make(const std::string& name, const std::string& json) {
    if constexpr (requires { typename T::Configuration; }) {
      using Configuration = typename T::Configuration;
      auto merged = MergeConfiguration(ToJson(Configuration{}), json);
      if (!merged) return merged.error();
      auto configuration = FromJson<Configuration>(*merged);
      if (!configuration) return configuration.error();
      return std::unique_ptr<Component>(std::make_unique<T>(name, *configuration));
    } else {
      if (!json.empty()) {
        return Error{ErrorCode::kInvalid, "it takes no configuration, got " + json};
      }
      return std::unique_ptr<Component>(std::make_unique<T>(name));
    }
  }
  /// The defaults, replaced by what `json` says; nested objects are merged.
  static Result<std::string> MergeConfiguration(const std::string& defaults,
                                                const std::string& json);

  std::map<std::string, Factory> factories_;
};

}  // namespace tendon
