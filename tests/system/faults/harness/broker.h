#pragma once

#include <algorithm>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "system/faults/harness/fault_test.h"

namespace faults {

/// A reader of a stream. It accepts no rows while the test holds its gate.
class GatedReader final : public tendon::RowSink {
 public:
  [[nodiscard]] std::unique_lock<std::mutex> HoldGate() { return std::unique_lock(gate_); }
  [[nodiscard]] StreamChecker::Verdict verdict() const { return checker_->verdict(); }

 private:
  void OnSubscribed(const std::vector<tendon::Schema>& columns) override {
    sink().OnSubscribed(columns);
  }
  void OnRows(const tendon::RowBatch& batch) override {
    const std::scoped_lock lock(gate_);
    sink().OnRows(batch);
  }
  void OnStale(const tendon::Error& reason) override { sink().OnStale(reason); }
  [[nodiscard]] tendon::RowSink& sink() const { return *checker_; }

  std::mutex gate_;
  const std::shared_ptr<StreamChecker> checker_ = std::make_shared<StreamChecker>();
};

/// A GCM with a broker, a process with a stream of large rows, and viewers. The viewers are in this
/// process, but behave like separate programs.
class BrokerTest : public FaultTest {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(StartBroker());
    if (HasNoBroker()) GTEST_SKIP() << broker_->err();
    gcm_ = std::make_unique<Program>(
        Command("gcm", As("gcm", {"serve", "--broker", broker_address_})), environment());
    ASSERT_TRUE(Eventually([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
    ASSERT_NO_FATAL_FAILURE(StartViewer());
    robot_ = MakeLcm("well", As("well"));
    ASSERT_TRUE(Eventually([this] {
      const auto catalogue = viewer_->catalogue();
      return catalogue.FindProvided({"well", "fountain", "state"}) != nullptr;
    })) << robot_->err();
  }

  /// Returns the command line `words`, with options that give the program the identity `name`.
  [[nodiscard]] virtual Words As(const std::string& /*name*/, Words words = {}) const {
    return words;
  }

  void StartBroker() {
    broker_ = std::make_unique<Program>(
        Command("gcm", As("broker", {"broker", "--listen", broker_address_})), environment());
    ASSERT_TRUE(Eventually([this] {
      return broker_->out().find("ready") != std::string::npos || HasNoBroker();
    })) << broker_->err();
  }

  [[nodiscard]] bool HasNoBroker() const {
    return broker_->err().find("is not installed; ") != std::string::npos;
  }

  void Watch(const std::shared_ptr<tendon::RowSink>& sink) {
    auto& viewer = viewers_.emplace_back(std::make_unique<tendon::GcmClient>(
        NewMiddleware(), tendon::GcmClient::Options{
                             .name = "other", .address = gcm_address_, .timeout = Timeout()}));
    ASSERT_TRUE(viewer->WaitUntilWatching().ok());
    viewer->telemetry().Subscribe(rows_, sink);
  }

  const tendon::TableSubscription rows_{"well", "fountain", "state", {"Sample", "Ballast"}};
  const std::string broker_address_ = "127.0.0.1:" + std::to_string(FreePort());
  std::unique_ptr<Program> broker_;
  std::vector<std::unique_ptr<tendon::GcmClient>> viewers_;
};

inline bool AllGetMore(const std::vector<std::shared_ptr<StreamChecker>>& streams,
                       std::uint64_t more) {
  std::vector<std::uint64_t> before;
  for (const auto& stream : streams) before.push_back(stream->received());
  return Eventually([&] {
    for (std::size_t i = 0; i < streams.size(); ++i) {
      if (streams[i]->received() < before[i] + more) return false;
    }
    return true;
  });
}

}  // namespace faults
