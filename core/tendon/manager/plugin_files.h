#pragma once

#include <tendon/base/os/file_content.h>
#include <tendon/manager/component_description.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// The files of the plug-ins that a process has loaded, and whether they have changed since.
/// Thread-safe.
class PluginFiles {
 public:
  /// Adds a plug-in. `content` is the content that was loaded.
  void Add(const std::string& library, os::FileContent content);
  /// Checks all files for changes; may block on the disk.
  void Update();
  /// A number that changes whenever descriptions() changes.
  [[nodiscard]] std::uint64_t revision() const;
  /// Returns the results of the last complete Update(), in the order of loading. Does not wait for
  /// a running Update().
  [[nodiscard]] std::vector<PluginDescription> descriptions() const;

 private:
  struct LoadedPlugin {
    std::string library;
    os::FileWatch file;
  };

  static PluginDescription Describe(LoadedPlugin& loaded);

  std::mutex update_mutex_;  // held during Update(); locked before mutex_
  std::vector<LoadedPlugin> loaded_;
  mutable std::mutex mutex_;  // guards the members below
  std::vector<PluginDescription> descriptions_;
  std::uint64_t revision_ = 0;
};

}  // namespace tendon
