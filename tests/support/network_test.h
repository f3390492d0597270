#pragma once

#include <gtest/gtest.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/process/process.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>

#include "support/folder.h"
#include "support/network_kinds.h"
#include "support/program.h"
#include "support/wait.h"

/// A GCM and processes in this program, each with its own middleware.
class NetworkTest : public testing::TestWithParam<NetworkKind> {
 protected:
  NetworkTest() { StartGcm(); }

  /// Starts a GCM, or restarts it at the same address.
  void StartGcm() {
    auto gcm = tendon::GlobalManager::Start(
        join_(),
        {.address = gcm_address_, .state_folder = folder_.path(), .clock = &tendon::SteadyClock()});
    ASSERT_TRUE(gcm.ok()) << gcm.error().message;
    gcm_ = *std::move(gcm);
  }
  void KillGcm() { gcm_.reset(); }
  tendon::GlobalManager& gcm() { return *gcm_; }

  /// With a history that is soon full, so that tests can judge how the memory grows.
  [[nodiscard]] tendon::ProcessOptions Options() const {
    return {
        .middleware = join_(), .gcm = gcm_address_, .history = {.memory = std::size_t{2} << 20U}};
  }
  /// Starts a process and waits until it has joined.
  [[nodiscard]] std::unique_ptr<tendon::Process> Start(const std::string& name) const {
    auto process = std::make_unique<tendon::Process>(name, Options());
    const auto joined = process->WaitUntilJoined(tendon::test::LongestWait());
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
  const tendon::test::Folder folder_;
  const std::string gcm_address_ = "127.0.0.1:" + std::to_string(FreePort());
  std::unique_ptr<tendon::GlobalManager> gcm_;
};

inline std::string NameOfNetwork(const testing::TestParamInfo<NetworkKind>& info) {
  return info.param.name;
}
