#pragma once

#include <tendon/manager/component_registry.h>
#include <tendon/manager/plugin_files.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// Loads component classes from plug-ins: shared libraries `NAME.so` in a list of folders, which
/// export TendonRegisterComponents. A plug-in stays loaded for the life of the process, as it was
/// when it was loaded, whatever becomes of its file: files() tells that.
///
/// One thread at a time.
class ComponentLoader {
 public:
  /// Folders are searched in order; $TENDON_COMPONENTS (a ':' list) comes before them, and behind
  /// them ../lib/tendon/components as seen from the program.
  explicit ComponentLoader(std::vector<std::filesystem::path> folders = {});

  /// Loads `library`, a bare name, unless it is loaded. Errors: kInvalid for a name with '/' or
  /// "..", kNotFound with the folders searched and a suggestion, kFailed with what is wrong with
  /// the file, in one sentence: the path, what was expected, what was found. A library is tried in
  /// another process first; one that fails is not loaded in this one and adds no class.
  Result<void> Load(const std::string& library);

  /// Loads the library and makes a component of one of its classes.
  Result<std::unique_ptr<Component>> Create(const std::string& library,
                                            const std::string& class_name, const std::string& name,
                                            const std::string& configuration_json);

  /// The classes of each library that is loaded, by its name.
  [[nodiscard]] const std::map<std::string, ComponentRegistry>& loaded() const { return loaded_; }
  /// From which files; shared with those who look at them in other threads.
  [[nodiscard]] const std::shared_ptr<PluginFiles>& files() const { return files_; }
  /// The name of each library in the folders, in order; whether it loads is not tried.
  [[nodiscard]] std::vector<std::string> available() const;

 private:
  [[nodiscard]] Result<std::filesystem::path> Find(const std::string& library) const;

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, ComponentRegistry> loaded_;
  std::shared_ptr<PluginFiles> files_ = std::make_shared<PluginFiles>();
};

}  // namespace tendon
