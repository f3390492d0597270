#pragma once

#include <tendon/manager/plugin_abi.h>
#include <tendon/payload/json.h>
#include <tendon/task/component.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tendon {

/// The description of a component class, for code that does not know its type.
struct ComponentClass {
  std::string name;
  Schema configuration;  ///< schema of None if the class takes no configuration
  std::string defaults;  ///< the default configuration, as JSON
};

/// The component classes that can be created by name. A plug-in adds its classes in
/// TendonRegisterComponents(), which is declared below.
///
/// The constructor of a class takes a name, or a name and a configuration. The configuration has
/// the type `Configuration`, a described payload inside the class. Members that are missing in the
/// JSON text have their default values.
class ComponentRegistry {
 public:
  using Factory = std::function<Result<std::unique_ptr<Component>>(const std::string& name,
                                                                   const std::string& json)>;

  /// Adds the class T. Throws ConfigurationError if a class with this name already exists.
  template <std::derived_from<Component> T>
  void Add(std::string class_name) {
    ComponentClass added{std::move(class_name), {}, ToJson(None{})};
    if constexpr (kConfigurable<T>) {
      using Configuration = typename T::Configuration;
      static_assert(RequirePayload<Configuration>());
      if constexpr (Payload<Configuration>) {
        added.configuration = SchemaOf<Configuration>();
        added.defaults = ToJson(Configuration{});
        AddFactory(std::move(added), &Make<T>);
      }
    } else {
      AddFactory(std::move(added), &Make<T>);
    }
  }
  void AddFactory(ComponentClass added, Factory factory);

  /// Creates a component. An error names the class and contains the message of its constructor.
  Result<std::unique_ptr<Component>> Create(const std::string& class_name, const std::string& name,
                                            const std::string& configuration_json) const;

  /// Sorted by name.
  [[nodiscard]] std::vector<ComponentClass> classes() const;
  [[nodiscard]] std::vector<std::string> class_names() const;

  /// Returns the JSON object `defaults` with its members replaced by those of `json`, which is a
  /// JSON object or empty. Nested objects are merged. Fails with kInvalid if one of the two is
  /// malformed; the error says why.
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
        return Error{ErrorCode::kInvalid, "the class takes no configuration, got " + json};
      }
      return std::unique_ptr<Component>(std::make_unique<T>(name));
    }
  }

  std::map<std::string, Entry> entries_;
};

}  // namespace tendon

/// Each plug-in defines this function, outside of any namespace, to add its classes:
///
///     void TendonRegisterComponents(tendon::ComponentRegistry& registry) {
///       registry.Add<arm::SimulatedArm>("SimulatedArm");
///     }
///
/// This declaration gives it C linkage and exports it, also from a library that is built with
/// -fvisibility=hidden.
extern "C" [[gnu::visibility("default")]] void TendonRegisterComponents(
    tendon::ComponentRegistry& registry);
