#pragma once

#include <tendon/base/os/loading/file_content.h>
#include <tendon/manager/description.h>

#include <mutex>
#include <string>
#include <vector>

namespace tendon {

/// The files from which a process has loaded plug-ins, and what has become of them. Thread-safe.
class PluginFiles {
 public:
  /// What was read from the file of the plug-in, and is loaded now.
  void Add(const std::string& library, os::FileContent content);
  /// Looks at all files, which may take as long as their disks do; true where the descriptions are
  /// others than before.
  bool Look();
  /// As of the last look, in the order in which they were loaded. Does not wait for a look.
  [[nodiscard]] std::vector<PluginDescription> descriptions() const;

 private:
  struct Loaded {
    std::string library;
    os::FileWatch file;
  };

  static PluginDescription Describe(Loaded& loaded);

  std::mutex look_mutex_;  // before mutex_
  std::vector<Loaded> loaded_;
  mutable std::mutex mutex_;  // of what follows
  std::vector<PluginDescription> descriptions_;
};

}  // namespace tendon
