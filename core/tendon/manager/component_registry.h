#pragma once

#include <tendon/manager/plugin_abi.h>
#include <tendon/payload/json.h>
#include <tendon/task/component.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// A class as those see it who do not know its type.
struct ComponentClass {
  std::string name;
  Schema configuration;  ///< of None where it takes none
  std::string defaults;  ///< the configuration of one that is told nothing, as JSON
};

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
    ComponentClass added{std::move(class_name), {}, ToJson(None{})};
    if constexpr (kConfigurable<T>) {
      static_assert(RequirePayload<typename T::Configuration>());
      added.configuration = SchemaOf<typename T::Configuration>();
      added.defaults = ToJson(typename T::Configuration{});
    }
    AddFactory(std::move(added), [](const std::string& name, const std::string& json) {
      return Make<T>(name, json);
    });
  }
  void AddFactory(ComponentClass added, Factory factory);

  /// Makes a component; errors name the class, and what its constructor said.
  Result<std::unique_ptr<Component>> Create(const std::string& class_name, const std::string& name,
                                            const std::string& configuration_json) const;

  /// In the order of their names.
  [[nodiscard]] std::vector<ComponentClass> classes() const;
  [[nodiscard]] std::vector<std::string> class_names() const;

  /// What a component is told: the defaults, JSON, replaced by what `json` says, a JSON object or
  /// empty; nested objects are merged. kInvalid says what is wrong with either.
  static Result<std::string> MergeConfiguration(const std::string& defaults,
                                                const std::string& json);

 private:
  struct Entry {
    ComponentClass description;
    Factory factory;
  };
  template <typename T>
  static constexpr bool kConfigurable = requires {
    typename T::Configuration;
  };

  template <typename T>
  static Result<std::unique_ptr<Component>> Make(const std::string& name, const std::string& json) {
    if constexpr (kConfigurable<T>) {
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

  std::map<std::string, Entry> entries_;
};

}  // namespace tendon
