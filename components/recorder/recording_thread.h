#pragma once

#include <components/recorder/recorder_payloads.h>
#include <tendon/base/clock.h>
#include <tendon/process/local_access.h>
#include <tendon/process/worker.h>
#include <tendon/recording/local_system.h>
#include <tendon/recording/recorder.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace recorder {

/// The outcome of an order or of a recording.
struct RecordingOutcome {
  enum class Kind { kStarted, kStopped, kSaved, kDelayed, kFailed };

  Kind kind = Kind::kFailed;
  std::string text;  ///< the file; for kDelayed and kFailed, a sentence
};

/// Makes recordings, one after the other, in its own thread, so that the disk never delays the
/// component.
///
/// Thread safety: all functions, from any thread. Only Finish() waits.
class RecordingThread {
 public:
  RecordingThread(std::shared_ptr<tendon::LocalAccess> process, RecorderConfiguration settings);
  RecordingThread(const RecordingThread&) = delete;
  RecordingThread& operator=(const RecordingThread&) = delete;
  /// Calls Finish().
  ~RecordingThread();

  /// Begins a recording, or begins to wait for its condition. Fails with kFailed if there is
  /// already a recording.
  void Start();
  /// Ends the recording and completes its file. Fails with kFailed if there is no recording.
  void Stop();
  /// Saves the history of the last `seconds`, which the process has kept, in a separate file.
  void SaveLast(double seconds);
  /// Executes all earlier orders, ends the recording if there is one, and waits for this.
  void Finish();

  [[nodiscard]] RecorderState state() const;
  /// Since the last call, oldest first.
  std::vector<RecordingOutcome> TakeOutcomes();

 private:
  // In the thread.
  void StartNow();
  void Begin();
  void StopNow();
  void SaveLastNow(double seconds);
  void Look();
  void SetWaiting(bool is_waiting);
  void Report(RecordingOutcome::Kind kind, std::string text);
  [[nodiscard]] tendon::recording::RecorderOptions NextRecording() const;
  [[nodiscard]] tendon::recording::FileOptions NextFile() const;

  const std::shared_ptr<tendon::LocalAccess> process_;
  const RecorderConfiguration settings_;

  // Of the thread.
  std::shared_ptr<tendon::recording::LocalSystem> system_;
  std::unique_ptr<tendon::recording::Recorder> recorder_;
  bool is_starting_ = false;                    // the process is too busy to list its components
  tendon::recording::RecorderOptions options_;  // of the recording that is being started
  int tries_ = 0;                               // to start it
  std::uint64_t starts_ = 0;
  bool is_waiting_ = false;  // for the condition to start
  std::uint64_t recordings_ = 0;
  std::uint64_t bytes_ = 0;  // a second ago
  tendon::SteadyTime next_rate_{};

  mutable std::mutex mutex_;  // guards the members below
  RecorderState state_;
  std::vector<RecordingOutcome> outcomes_;

  tendon::Worker worker_{"recorder"};  // last, so that its thread ends first
};

}  // namespace recorder
