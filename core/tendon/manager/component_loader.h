#pragma once

#include <tendon/manager/component_registry.h>
#include <tendon/manager/plugin_files.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// Loads component classes from plug-ins. A plug-in is a shared library `NAME.so` that exports the
/// function TendonRegisterComponents. The loader searches several folders. A plug-in stays loaded
/// and unchanged until the process ends, even if its file changes; files() shows such changes.
///
/// Used by one thread at a time.
class ComponentLoader {
 public:
  /// The folders are searched in this order: those in $TENDON_COMPONENTS (separated by ':'), then
  /// `folders`, then ../lib/tendon/components relative to the folder of the program.
  explicit ComponentLoader(std::vector<std::filesystem::path> folders = {});

  /// Loads the plug-in with the name `library`, which has no path. Does nothing if it is already
  /// loaded. First loads the plug-in in a separate process as a test. If the test fails, this
  /// process does not load the plug-in.
  ///
  /// Errors: kInvalid if the name contains '/' or ".."; kNotFound if there is no such plug-in (the
  /// error lists the searched folders and suggests a name); kFailed if the plug-in cannot be loaded
  /// (the error says which file, what was expected and what was found).
  Result<void> Load(const std::string& library);

  /// Loads the plug-in if necessary, and creates a component of one of its classes.
  Result<std::unique_ptr<Component>> Create(const std::string& library,
                                            const std::string& class_name, const std::string& name,
                                            const std::string& configuration_json);

  /// The classes of each loaded plug-in, by name of the plug-in.
  [[nodiscard]] const std::map<std::string, ComponentRegistry>& loaded() const { return loaded_; }
  /// The files of the loaded plug-ins. Shared, because other threads check them for changes.
  [[nodiscard]] const std::shared_ptr<PluginFiles>& files() const { return files_; }
  /// Returns the names of the plug-ins in the folders, sorted. The files are not checked.
  [[nodiscard]] std::vector<std::string> available() const;

 private:
  [[nodiscard]] Result<std::filesystem::path> Find(const std::string& library) const;

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, ComponentRegistry> loaded_;
  std::shared_ptr<PluginFiles> files_ = std::make_shared<PluginFiles>();
};

}  // namespace tendon
