#pragma once

#include <tendon/manager/component_registry.h>
#include <tendon/manager/plugin_files.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace tendon {

/// Loads component classes from plug-ins: shared libraries `NAME.so` in a list of folders, which
/// export TendonRegisterComponents. A plug-in stays loaded, unchanged, for the life of the process,
/// even if its file changes; files() shows such changes.
///
/// Used by one thread at a time.
class ComponentLoader {
 public:
  /// Folders are searched in this order: those in $TENDON_COMPONENTS (separated by ':'), `folders`,
  /// and ../lib/tendon/components relative to the program.
  explicit ComponentLoader(std::vector<std::filesystem::path> folders = {});

  /// Loads `library`, a bare name; does nothing if it is already loaded. Errors: kInvalid for a
  /// name with '/' or "..", kNotFound with the searched folders and a suggestion, kFailed with one
  /// sentence about the file: its path, what was expected, what was found. A library is first
  /// loaded in a separate process, as a test; if it fails there, it is not loaded in this one and
  /// adds no class.
  Result<void> Load(const std::string& library);

  /// Loads the library and creates a component of one of its classes.
  Result<std::unique_ptr<Component>> Create(const std::string& library,
                                            const std::string& class_name, const std::string& name,
                                            const std::string& configuration_json);

  /// The classes of each loaded library, by the library's name.
  [[nodiscard]] const std::map<std::string, ComponentRegistry>& loaded() const { return loaded_; }
  /// The loaded files; shared with other threads that watch them.
  [[nodiscard]] const std::shared_ptr<PluginFiles>& files() const { return files_; }
  /// The names of the libraries in the folders, sorted; the files are not checked.
  [[nodiscard]] std::vector<std::string> available() const;

 private:
  [[nodiscard]] Result<std::filesystem::path> Find(const std::string& library) const;

  std::vector<std::filesystem::path> folders_;
  std::map<std::string, ComponentRegistry> loaded_;
  std::shared_ptr<PluginFiles> files_ = std::make_shared<PluginFiles>();
};

}  // namespace tendon
