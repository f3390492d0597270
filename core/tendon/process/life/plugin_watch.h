#pragma once

#include <tendon/manager/plugin_files.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace tendon {

/// Looks once a second at the files of the plug-ins that a process has loaded, in a thread of its
/// own: a slow disk holds up nobody but orders that load.
class PluginWatch {
 public:
  /// `changed` is called in that thread whenever something is other than before.
  PluginWatch(std::shared_ptr<PluginFiles> files, std::function<void()> changed);
  PluginWatch(const PluginWatch&) = delete;
  PluginWatch& operator=(const PluginWatch&) = delete;
  /// `changed` is not called any more.
  ~PluginWatch();

 private:
  void Run();

  const std::shared_ptr<PluginFiles> files_;
  const std::function<void()> changed_;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool is_ending_ = false;
  std::thread thread_;  // last: it uses the others
};

}  // namespace tendon
