#pragma once

#include <gcm_gui/files/gui_poster.h>
#include <gcm_gui/recording/recording_runner.h>
#include <tendon/gcm/client.h>
#include <tendon/middleware/middleware.h>

#include <chrono>
#include <memory>
#include <thread>

namespace tendon::gui {

/// Records in a thread of its own, with the recorder of `gcm record`, so that neither the disk nor
/// the network can delay the window.
class RecordingWorker final : public RecordingRunner {
  Q_OBJECT

 public:
  /// How long the end of the window waits for the file.
  static constexpr std::chrono::seconds kPatience{15};

  /// `options` are those of the window's client. Each recording connects as another viewer.
  RecordingWorker(std::shared_ptr<Middleware> middleware, GcmClient::Options options);
  /// Calls complete().
  ~RecordingWorker() override;

  void start(const RecordingRequest& request) override;
  void stop() override;
  /// Stops the recording, and waits until its file is complete, at most `patience`; then reports
  /// the incomplete file on stderr. For the end of the window.
  void complete(std::chrono::milliseconds patience = kPatience);

 private:
  class Run;

  const std::shared_ptr<Middleware> middleware_;
  const GcmClient::Options options_;
  std::shared_ptr<GuiPoster> poster_;
  std::shared_ptr<Run> run_;  // the latest one
  std::thread thread_;
};

}  // namespace tendon::gui
