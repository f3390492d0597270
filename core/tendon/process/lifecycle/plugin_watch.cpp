#include <tendon/process/lifecycle/plugin_watch.h>

#include <tendon/base/os/thread.h>

#include <chrono>
#include <cstdint>
#include <utility>

namespace tendon {

PluginWatch::PluginWatch(std::shared_ptr<PluginFiles> files, std::function<void()> changed)
    : files_(std::move(files)), changed_(std::move(changed)), thread_([this] { Run(); }) {}

PluginWatch::~PluginWatch() {
  {
    const std::scoped_lock lock(mutex_);
    is_ending_ = true;
  }
  ending_.notify_all();
  thread_.join();
}

void PluginWatch::Run() {
  constexpr std::chrono::seconds kBetweenLooks(1);
  os::NameThisThread("plugin watch");
  std::uint64_t reported_revision = 0;  // orders also change the revision
  std::unique_lock lock(mutex_);
  while (!ending_.wait_for(lock, kBetweenLooks, [this] { return is_ending_; })) {
    lock.unlock();
    files_->Update();
    if (const std::uint64_t now = files_->revision(); now != std::exchange(reported_revision, now))
      changed_();
    lock.lock();
  }
}

}  // namespace tendon
