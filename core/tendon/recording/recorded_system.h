#pragma once

#include <tendon/gcm/client.h>

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace tendon::recording {

/// A system that a recorder can record: either all processes that a GCM knows, or only the process
/// of the program.
///
/// Thread safety: any thread may call all functions, but handlers and sinks may not. The recorder
/// calls them in its follower thread, and in the thread that starts and stops it.
class RecordedSystem {
 public:
  RecordedSystem() = default;
  RecordedSystem(const RecordedSystem&) = delete;
  RecordedSystem& operator=(const RecordedSystem&) = delete;
  virtual ~RecordedSystem() = default;

  /// The revision of catalogue(). Must be cheap, because a recorder calls this function ten times a
  /// second.
  [[nodiscard]] virtual std::uint64_t revision() = 0;
  [[nodiscard]] virtual Catalogue catalogue() const = 0;
  /// If the catalogue is empty because the system has not answered yet, returns the reason.
  [[nodiscard]] virtual std::optional<Error> WhyUnknown() { return std::nullopt; }
  [[nodiscard]] virtual TelemetryClient& telemetry() = 0;
  virtual GcmClient::ListenerId Listen(const EventSubscription& events,
                                       std::shared_ptr<EventSink> sink) = 0;
  /// After this function has returned, the sink is not called any more.
  virtual void StopListening(GcmClient::ListenerId id) = 0;
  /// See GcmClient::ReadPastEvents().
  virtual void ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds last,
                              std::shared_ptr<EventSink> sink,
                              std::function<void(const PastEvents&)> done) = 0;
  // The following three functions wait for the reply of the process.
  virtual Result<message::ReadLogReply> ReadLog(const std::string& process,
                                                const message::ReadLog& wanted) = 0;
  virtual Result<message::ProcessHistoryState> GetProcessHistory(const std::string& process) = 0;
  virtual Result<Schema> FindSchema(const std::string& process, Fingerprint type) = 0;
  /// Makes the listener receive the whole catalogue again.
  virtual void Resync() = 0;
  /// From now on, the listener receives the log.
  virtual void WatchLog() = 0;
};

/// All processes that a GCM knows. The client must outlive it.
class GcmSystem final : public RecordedSystem {
 public:
  /// `timeout` is the timeout of the client. The client ends its requests by itself, and its errors
  /// name the process. Therefore, this object waits longer: until the client has opened a link and
  /// has waited for the reply.
  GcmSystem(GcmClient& client, std::chrono::milliseconds timeout)
      : client_(client), reply_timeout_(2 * timeout + std::chrono::seconds(1)) {}

  std::uint64_t revision() override {
    std::uint64_t revision = 0;
    client_.WithCatalogue([&](const Catalogue& now) { revision = now.revision(); });
    return revision;
  }
  [[nodiscard]] Catalogue catalogue() const override { return client_.catalogue(); }
  TelemetryClient& telemetry() override { return client_.telemetry(); }
  GcmClient::ListenerId Listen(const EventSubscription& events,
                               std::shared_ptr<EventSink> sink) override {
    return client_.Listen(events, std::move(sink));
  }
  void StopListening(GcmClient::ListenerId id) override { client_.StopListening(id); }
  void ReadPastEvents(const EventSubscription& events, std::chrono::nanoseconds last,
                      std::shared_ptr<EventSink> sink,
                      std::function<void(const PastEvents&)> done) override {
    client_.ReadPastEvents(events, last, std::move(sink), std::move(done));
  }
  Result<message::ReadLogReply> ReadLog(const std::string& process,
                                        const message::ReadLog& wanted) override {
    return Wait<message::ReadLogReply>(
        reply_timeout_, [&](auto handler) { client_.ReadLog(process, wanted, handler); });
  }
  Result<message::ProcessHistoryState> GetProcessHistory(const std::string& process) override {
    return Wait<message::ProcessHistoryState>(
        reply_timeout_, [&](auto handler) { client_.GetProcessHistory(process, handler); });
  }
  Result<Schema> FindSchema(const std::string& process, Fingerprint type) override {
    return Wait<Schema>(reply_timeout_,
                        [&](auto handler) { client_.GetSchema(process, type, handler); });
  }
  void Resync() override { client_.Resync(); }
  void WatchLog() override { client_.WatchLog(); }

 private:
  GcmClient& client_;
  const std::chrono::milliseconds reply_timeout_;
};

}  // namespace tendon::recording
