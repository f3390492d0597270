#pragma once

#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/recording/recording_runner.h>
#include <tendon/gcm/client.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <memory>
#include <thread>

namespace tendon::gui {

/// Records in its own thread, with the recorder of `gcm record`, so that the disk and the network
/// cannot delay the window.
class RecordingWorker final : public RecordingRunner {
  Q_OBJECT

 public:
  /// When the window ends, it waits this long for the file.
  static constexpr std::chrono::seconds kTimeout{15};

  /// `options` are the options of the window's client. Each recording connects as a separate
  /// viewer.
  RecordingWorker(std::shared_ptr<Middleware> middleware, GcmClient::Options options);
  /// Calls complete().
  ~RecordingWorker() override;

  void start(const RecordingRequest& request) override;
  void stop() override;
  /// Called at the end of the window. Stops the recording, and waits at most `timeout` until its
  /// file is complete. If it is still incomplete, reports this on stderr.
  void complete(std::chrono::milliseconds timeout = kTimeout);

 private:
  class Run;

  const std::shared_ptr<Middleware> middleware_;
  const GcmClient::Options options_;
  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<Run> run_;  // the latest run
  std::thread thread_;
};

}  // namespace tendon::gui
