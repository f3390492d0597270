#pragma once

#include <tendon/base/os/file_content.h>
#include <tendon/manager/component_description.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// The files of the plug-ins that a process has loaded, and their states. Thread-safe.
class PluginFiles {
 public:
  /// `content` was read from the file of the plug-in and is now loaded.
  void Add(const std::string& library, os::FileContent content);
  /// Checks all files, which may take as long as their disks need.
  void Look();
  /// Changes whenever the descriptions do.
  [[nodiscard]] std::uint64_t revision() const;
  /// As of the last Look(), in the order of loading. Does not wait for a Look().
  [[nodiscard]] std::vector<PluginDescription> descriptions() const;

 private:
  struct Loaded {
    std::string library;
    os::FileWatch file;
  };

  static PluginDescription Describe(Loaded& loaded);

  std::mutex look_mutex_;  // locked before mutex_
  std::vector<Loaded> loaded_;
  mutable std::mutex mutex_;  // guards what follows
  std::vector<PluginDescription> descriptions_;
  std::uint64_t revision_ = 0;
};

}  // namespace tendon
