#pragma once

#include <gtest/gtest.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/process/process.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>

#include "support/network_kinds.h"
#include "support/wait.h"

/// A GCM and processes, each with a middleware of its own, all in this program.
class NetworkTest : public testing::TestWithParam<NetworkKind> {
 protected:
  NetworkTest() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->name()) + std::to_string(getpid());
    std::replace(name.begin(), name.end(), '/', '-');
    folder_ = std::filesystem::path(testing::TempDir()) / name;
    StartGcm();
  }
  ~NetworkTest() override {
    gcm_.reset();
    std::filesystem::remove_all(folder_);
  }

  /// Where it was before.
  void StartGcm() {
    auto gcm = tendon::GlobalManager::Start(
        join_(),
        {.address = gcm_address_, .state_folder = folder_, .clock = &tendon::SteadyClock()});
    ASSERT_TRUE(gcm.ok()) << gcm.error().message;
    gcm_ = *std::move(gcm);
    gcm_address_ = gcm_->address();
  }
  void KillGcm() { gcm_.reset(); }
  tendon::GlobalManager& gcm() { return *gcm_; }

  [[nodiscard]] tendon::ProcessOptions Options() const {
    return {.middleware = join_(), .gcm = gcm_address_};
  }
  /// A process that has joined.
  [[nodiscard]] std::unique_ptr<tendon::Process> Start(const std::string& name) const {
    auto process = std::make_unique<tendon::Process>(name, Options());
    const auto joined = process->WaitUntilJoined(std::chrono::seconds(20));
    EXPECT_TRUE(joined.ok()) << joined.error().message;
    return process;
  }
  [[nodiscard]] std::shared_ptr<tendon::Middleware> NewMiddleware() const { return join_(); }

  static bool EventuallyActive(const tendon::Process& process, std::size_t connections) {
    return EventuallyTrue([&] {
      const auto all = process.connections();
      return all.size() == connections && std::all_of(all.begin(), all.end(), [](const auto& one) {
               return one.state == tendon::ConnectionState::kActive;
             });
    });
  }
  static bool EventuallyPending(const tendon::Process& process) {
    return EventuallyTrue([&] {
      const auto all = process.connections();
      return all.size() == 1 && all.front().state == tendon::ConnectionState::kPending;
    });
  }

 private:
  NetworkKind::Join join_ = GetParam().make();
  std::filesystem::path folder_;
  std::string gcm_address_ = "127.0.0.1:0";
  std::unique_ptr<tendon::GlobalManager> gcm_;
};

inline std::string NameOfNetwork(const testing::TestParamInfo<NetworkKind>& info) {
  return info.param.name;
}
