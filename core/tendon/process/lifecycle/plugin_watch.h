#pragma once

#include <tendon/manager/plugin_files.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

namespace tendon {

/// Checks the files of the loaded plug-ins of a process once a second. Uses its own thread, so that
/// a slow disk delays only orders that load plug-ins.
class PluginWatch {
 public:
  /// Starts the thread, which calls `changed` after each change.
  PluginWatch(std::shared_ptr<PluginFiles> files, std::function<void()> changed);
  PluginWatch(const PluginWatch&) = delete;
  PluginWatch& operator=(const PluginWatch&) = delete;
  /// Stops the thread. After this, `changed` is not called any more.
  ~PluginWatch();

 private:
  void Run();

  const std::shared_ptr<PluginFiles> files_;
  const std::function<void()> changed_;
  std::mutex mutex_;
  std::condition_variable ending_;
  bool is_ending_ = false;
  std::thread thread_;  // last, because it uses the other members
};

}  // namespace tendon
