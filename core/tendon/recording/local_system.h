#pragma once

#include <tendon/gcm/client/event_feed.h>
#include <tendon/gcm/client/process_links.h>
#include <tendon/gcm/client/process_requests.h>
#include <tendon/process/local_access.h>
#include <tendon/process/log/scoped_log_sink.h>
#include <tendon/recording/recorded_system.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

namespace tendon::recording {

/// The process of the program as a system that can be recorded, without a GCM and without a
/// network: its components and connections, their rows and events, and its log. The component
/// `Recorder` uses it. Rows are read as for any viewer, so the recorded components never wait.
///
/// Thread safety: as for RecordedSystem. This object has five threads, which mostly wait. It must
/// be destroyed before the process.
class LocalSystem final : public RecordedSystem {
 public:
  /// Waits for up to 200 ms if the process is busy with a request. If it stays busy, revision()
  /// finds its components later. The listener receives the catalogue and its changes in the thread
  /// that calls revision(), and the log in the threads that log. `timeout` is the time limit of a
  /// request.
  LocalSystem(std::shared_ptr<LocalAccess> process, std::shared_ptr<GcmListener> listener,
              std::chrono::milliseconds timeout = std::chrono::seconds(2));
  ~LocalSystem() override;

  /// First checks the process, which takes about 10 us for each component. While the process is
  /// busy with a request, returns the revision of the last check.
  std::uint64_t revision() override;
  [[nodiscard]] Catalogue catalogue() const override;
  /// Returns kFailed if the process was always busy.
  [[nodiscard]] std::optional<Error> WhyUnknown() override;
  TelemetryClient& telemetry() override { return *telemetry_; }
  GcmClient::ListenerId Listen(const EventSubscription& events,
                               std::shared_ptr<EventSink> sink) override;
  void StopListening(GcmClient::ListenerId id) override;
  void ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds last,
                      std::shared_ptr<EventSink> sink,
                      std::function<void(const PastEvents&)> done) override;
  Result<message::ReadLogReply> ReadLog(const std::string& process,
                                        const message::ReadLog& wanted) override;
  Result<message::ProcessHistoryState> GetProcessHistory(const std::string& process) override;
  Result<Schema> FindSchema(const std::string& process, Fingerprint type) override;
  void Resync() override;
  /// The listener gets only new records. ReadLog() returns the earlier records.
  void WatchLog() override;

 private:
  [[nodiscard]] Result<void> CheckProcess(const std::string& process) const;
  void OnLog(LogLevel level, std::string_view source, std::string_view text);

  const std::shared_ptr<LocalAccess> process_;
  const std::shared_ptr<GcmListener> listener_;
  const std::chrono::milliseconds timeout_;
  const std::shared_ptr<Worker> timer_ = std::make_shared<Worker>("rec timer");
  mutable std::mutex mutex_;  // guards the members below
  ProcessContent content_;
  Catalogue catalogue_;
  std::optional<ScopedLogSink> log_;

  // Destroyed before the members above, which its threads may use until then.
  const std::shared_ptr<Middleware> middleware_;
  std::shared_ptr<client::ProcessLinks> links_;
  std::shared_ptr<client::ProcessRequests> requests_;
  std::shared_ptr<client::EventFeed> events_;
  std::unique_ptr<TelemetryClient> telemetry_;
};

}  // namespace tendon::recording
