#pragma once

#include <components/recorder/recorder_payloads.h>
#include <components/recorder/recording_thread.h>
#include <tendon/interface/event.h>
#include <tendon/manager/local_manager.h>
#include <tendon/task/periodic_task.h>

#include <memory>
#include <string>

namespace recorder {

/// Records the components of its own process into MCAP files, without the network. README.md
/// describes its interfaces.
///
/// Its cycle, at 10 Hz, only forwards orders and copies a state. Another thread does the work. The
/// recorded components never wait for it.
class RecorderComponent final : public tendon::PeriodicTask, public tendon::ManagerClient {
 public:
  using Configuration = RecorderConfiguration;

  /// Throws ConfigurationError if the configuration is invalid.
  explicit RecorderComponent(std::string name, Configuration configuration = {});
  ~RecorderComponent() override { Join(); }

  /// Throws ConfigurationError unless the manager is a Process.
  void OnAdding(tendon::LocalManager& manager) override;

 private:
  void Startup() override;
  void Run() override;
  /// Ends the recording, and completes its file.
  void Cleanup() override;

  void StartRecording() { thread_->Start(); }
  void StopRecording() { thread_->Stop(); }
  void SaveLast(double seconds) { thread_->SaveLast(seconds); }
  void RaiseEvents();

  const Configuration configuration_;
  std::shared_ptr<tendon::LocalAccess> process_;
  std::unique_ptr<RecordingThread> thread_;  // while the component runs

  RecorderState state_;
  tendon::WriteEvent<std::string> started_;
  tendon::WriteEvent<std::string> stopped_;
  tendon::WriteEvent<std::string> saved_;
  tendon::WriteEvent<std::string> failed_;
};

}  // namespace recorder
