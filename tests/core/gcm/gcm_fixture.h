#pragma once

#include <gtest/gtest.h>
#include <tendon/gcm/client.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/middleware/tcp.h>
#include <tests/core/gcm/fake_process.h>
#include <tests/core/gcm/samples.h>
#include <tests/support/folder.h>
#include <tests/support/program.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace tendon::test {

/// Records all reports to a client.
class Recorder : public GcmListener {
 public:
  void OnSnapshot(const Catalogue& catalogue) override {
    const std::scoped_lock lock(mutex_);
    catalogue_ = catalogue;
    ++snapshots_;
  }
  void OnChanges(const std::vector<CatalogueChange>& changes) override {
    const std::scoped_lock lock(mutex_);
    for (const CatalogueChange& change : changes) {
      if (!catalogue_.Apply(change)) ++holes_;
      changes_.push_back(change);
    }
  }
  void OnGcmLost(const Error& reason) override {
    const std::scoped_lock lock(mutex_);
    losses_.push_back(reason);
  }

  [[nodiscard]] Catalogue catalogue() const {
    const std::scoped_lock lock(mutex_);
    return catalogue_;
  }
  [[nodiscard]] std::vector<CatalogueChange> changes() const {
    const std::scoped_lock lock(mutex_);
    return changes_;
  }
  [[nodiscard]] std::vector<Error> losses() const {
    const std::scoped_lock lock(mutex_);
    return losses_;
  }
  [[nodiscard]] int snapshots() const {
    const std::scoped_lock lock(mutex_);
    return snapshots_;
  }
  [[nodiscard]] int holes() const {
    const std::scoped_lock lock(mutex_);
    return holes_;
  }

 private:
  mutable std::mutex mutex_;
  Catalogue catalogue_;
  std::vector<CatalogueChange> changes_;
  std::vector<Error> losses_;
  int snapshots_ = 0;
  int holes_ = 0;
};

/// A GCM, processes and clients. Each has its own middleware, of the kind given by the parameter.
class GcmFixture : public testing::TestWithParam<std::string> {
 protected:
  static constexpr std::chrono::milliseconds kLong{20'000};

  GcmFixture() { StartGcm("127.0.0.1:" + std::to_string(FreePort())); }

  [[nodiscard]] std::shared_ptr<Middleware> NewMiddleware() const {
    if (GetParam() == "tcp") return MakeTcpMiddleware(Exposure::kLoopbackOnly);
    return std::make_shared<LoopbackMiddleware>(network_);
  }

  void StartGcm(const std::string& address) {
    auto gcm = GlobalManager::Start(NewMiddleware(), {.address = address,
                                                      .state_folder = folder_.path(),
                                                      .clock = &clock_,
                                                      .order_timeout = order_timeout_});
    ASSERT_TRUE(gcm) << gcm.error().message;
    gcm_ = *std::move(gcm);
    address_ = gcm_->address();
  }

  /// Creates a process with these components, which joins the GCM.
  std::unique_ptr<FakeProcess> Join(const std::string& name,
                                    const std::vector<ComponentDescription>& components) {
    auto process = std::make_unique<FakeProcess>(NewMiddleware(), name);
    for (const auto& component : components) process->Add(component);
    const auto joined = process->Join(address_);
    EXPECT_TRUE(joined) << joined.error().message;
    return process;
  }

  /// Creates a client that has received the catalogue.
  std::unique_ptr<GcmClient> Watch(std::shared_ptr<GcmListener> listener = nullptr,
                                   const std::string& name = "test") {
    auto client = std::make_unique<GcmClient>(
        NewMiddleware(), GcmClient::Options{.name = name, .address = address_, .timeout = kLong},
        std::move(listener));
    const auto watching = client->WaitUntilWatching();
    EXPECT_TRUE(watching) << watching.error().message;
    return client;
  }

  static Result<ConnectionDescription> Connect(GcmClient& client,
                                               const InterfaceName& required = kRobot,
                                               const InterfaceName& provided = kControl) {
    return Wait<ConnectionDescription>(
        kLong, [&](auto handler) { client.Connect(required, provided, handler); });
  }
  static Result<void> Disconnect(GcmClient& client, const InterfaceName& required = kRobot) {
    return Wait<void>(kLong, [&](auto handler) { client.Disconnect(required, handler); });
  }
  static Result<message::HistoryEntry> Undo(GcmClient& client) {
    return Wait<message::HistoryEntry>(kLong, [&](auto handler) { client.Undo(handler); });
  }
  static std::vector<message::HistoryEntry> Steps(GcmClient& client) {
    const auto history =
        Wait<message::History>(kLong, [&](auto handler) { client.GetHistory(handler); });
    EXPECT_TRUE(history);
    return history ? history->entries : std::vector<message::HistoryEntry>{};
  }

  [[nodiscard]] ProcessState StateOf(const std::string& process) const {
    const Catalogue catalogue = gcm_->catalogue();
    const ProcessEntry* entry = catalogue.FindProcess(process);
    EXPECT_NE(entry, nullptr) << process;
    return entry == nullptr ? ProcessState::kLeft : entry->process.state;
  }

  /// Advances the clock by this time, in steps as long as the ticks of a GCM.
  void Pass(std::chrono::milliseconds time) {
    constexpr std::chrono::milliseconds kStep(50);
    for (auto passed = std::chrono::milliseconds(0); passed < time; passed += kStep) {
      clock_.Advance(kStep);
      gcm_->Tick();
    }
  }

  const std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  const Folder folder_;
  ManualClock clock_;
  std::chrono::milliseconds order_timeout_ = kLong;
  std::unique_ptr<GlobalManager> gcm_;
  std::string address_;
};

/// A process robot with an arm, and a process desk that needs one.
class DeskAndRobot : public GcmFixture {
 protected:
  void SetUp() override {
    robot_ = Join("robot", {Arm(), FakeArm()});
    desk_ = Join("desk", {Teleoperation()});
    client_ = Watch(nullptr, "gcm connect");
  }

  /// Restarts only the GCM. The processes continue to run, and join the GCM again.
  void RestartGcm() {
    client_.reset();
    gcm_.reset();
    StartGcm(address_);
    ASSERT_TRUE(robot_->Join(address_));
    ASSERT_TRUE(desk_->Join(address_));
    client_ = Watch();
  }

  /// Returns the connection of the desk's only required interface; empty if there is none.
  [[nodiscard]] std::optional<ConnectionDescription> Connection() const {
    const Catalogue catalogue = gcm_->catalogue();
    const auto* connection = catalogue.FindConnection(kRobot);
    return connection == nullptr ? std::nullopt : std::optional(*connection);
  }

  std::unique_ptr<FakeProcess> robot_;
  std::unique_ptr<FakeProcess> desk_;
  std::unique_ptr<GcmClient> client_;
};

inline std::string NameOfParameter(const testing::TestParamInfo<std::string>& info) {
  return info.param;
}

}  // namespace tendon::test
