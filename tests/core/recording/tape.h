#pragma once

#include <gtest/gtest.h>
#include <support/wait.h>
#include <tendon/gcm/client.h>
#include <tendon/recording/recorder.h>
#include <tendon/recording/recording_queue.h>
#include <tendon/recording/recording_selection.h>
#include <tendon/recording/recording_writer.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tendon::recording {

/// Counts the subscribed sinks, so that no row is missed at the beginning.
class Readiness {
 public:
  void Set() { ++count_; }
  [[nodiscard]] bool IsReached(int count) const { return count_.load() >= count; }

 private:
  std::atomic<int> count_{0};
};

class TellingRowSink final : public RowSink {
 public:
  TellingRowSink(std::shared_ptr<RowSink> to, Readiness& readiness)
      : to_(std::move(to)), readiness_(readiness) {}
  void OnSubscribed(const std::vector<Schema>& columns) override {
    to_->OnSubscribed(columns);
    readiness_.Set();
  }
  void OnRows(const RowBatch& batch) override { to_->OnRows(batch); }
  void OnStale(const Error& reason) override { to_->OnStale(reason); }

 private:
  const std::shared_ptr<RowSink> to_;
  Readiness& readiness_;
};

class TellingEventSink final : public EventSink {
 public:
  TellingEventSink(std::shared_ptr<EventSink> to, Readiness& readiness)
      : to_(std::move(to)), readiness_(readiness) {}
  void OnListening(const std::vector<MemberDescription>& events) override {
    to_->OnListening(events);
    readiness_.Set();
  }
  void OnEvent(std::size_t event, std::span<const std::byte> value,
               const EventTime& time) override {
    to_->OnEvent(event, value, time);
  }
  void OnEventsLost(std::size_t event, std::uint64_t lost) override {
    to_->OnEventsLost(event, lost);
  }
  void OnStale(const Error& reason) override { to_->OnStale(reason); }

 private:
  const std::shared_ptr<EventSink> to_;
  Readiness& readiness_;
};

/// Records one component, from the moment when it is active and all its tables, events and commands
/// are subscribed, so that a test knows each row that must be in the file.
class Tape {
 public:
  Tape(std::shared_ptr<Middleware> middleware, const std::string& gcm,
       const std::filesystem::path& file, const InterfaceName& source,
       const std::map<Fingerprint, Schema>& types = {})
      : client_(std::move(middleware), {.name = "tape", .address = gcm}, queue_) {
    auto writer = RecordingWriter::Create({.file = file}, {});
    EXPECT_TRUE(writer) << writer.error().message;
    writer_ = *std::move(writer);
    EXPECT_TRUE(client_.WaitUntilWatching());
    EXPECT_TRUE(EventuallyTrue([&] {
      const Catalogue catalogue = client_.catalogue();
      const auto* component = catalogue.FindComponent(source.process, source.component);
      return component != nullptr && component->state == ComponentState::kActive;
    }));
    RecordingSelection all =
        Select(client_.catalogue(), {source.process + "/" + source.component + "/**"});
    for (const TableSubscription& table : all.tables) {
      subscriptions_.push_back(client_.telemetry().Subscribe(
          table, std::make_shared<TellingRowSink>(queue_->SinkOf(table), readiness_)));
    }
    all.events.insert(all.events.end(), all.commands.begin(), all.commands.end());
    for (const EventSubscription& events : all.events) {
      listeners_.push_back(client_.Listen(
          events, std::make_shared<TellingEventSink>(queue_->SinkOf(events, types), readiness_)));
    }
    const auto sinks = static_cast<int>(all.tables.size() + all.events.size());
    EXPECT_TRUE(EventuallyTrue([&] { return readiness_.IsReached(sinks); }));
  }

  /// Writes everything that has arrived.
  Counts Write() {
    for (const RecordingEntry& entry : queue_->Take(std::chrono::milliseconds(1)))
      EXPECT_TRUE(writer_->Write(entry));
    return writer_->counts();
  }
  void Sync() const { EXPECT_TRUE(writer_->Sync()); }
  void Close() {
    for (const auto id : subscriptions_) client_.telemetry().Unsubscribe(id);
    for (const auto id : listeners_) client_.StopListening(id);
    while (queue_->waiting_bytes() > 0) Write();
    EXPECT_TRUE(writer_->Close(queue_->losses()));
  }

 private:
  const std::shared_ptr<RecordingQueue> queue_ = std::make_shared<RecordingQueue>();
  Readiness readiness_;
  GcmClient client_;
  std::unique_ptr<RecordingWriter> writer_;
  std::vector<TelemetryClient::Id> subscriptions_;
  std::vector<GcmClient::ListenerId> listeners_;
};

}  // namespace tendon::recording
