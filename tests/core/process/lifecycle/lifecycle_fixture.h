#pragma once

#include <gmock/gmock.h>
#include <tendon/gcm/client.h>
#include <tendon/manager/component_loader.h>

#include <future>
#include <memory>
#include <string>
#include <vector>

#include "support/network_test.h"
#include "support/program.h"

inline std::shared_ptr<tendon::ComponentLoader> LoaderOfLamps() {
  const std::vector<std::filesystem::path> folders{Built("tests/support/built")};
  return std::make_shared<tendon::ComponentLoader>(folders);
}

/// A process that creates components from the plug-in `lamps`, its GCM, and a client that sends the
/// orders.
class LifecycleFixture : public NetworkTest {
 protected:
  static constexpr std::chrono::milliseconds kLong{20'000};

  void SetUp() override {
    tendon::ProcessOptions options = Options();
    options.loader = LoaderOfLamps();
    robot_ = std::make_unique<tendon::Process>("robot", options);
    ASSERT_TRUE(robot_->WaitUntilJoined(kLong).ok());
    client_ = NewClient(tendon::Role::kOperator);
  }
  void TearDown() override {
    client_.reset();
    robot_.reset();
  }

  [[nodiscard]] std::unique_ptr<tendon::GcmClient> NewClient(tendon::Role role,
                                                             const std::string& name = "test") {
    auto client = std::make_unique<tendon::GcmClient>(
        NewMiddleware(),
        tendon::GcmClient::Options{
            .name = name, .address = gcm().address(), .timeout = kLong, .role = role});
    EXPECT_TRUE(client->WaitUntilWatching().ok());
    return client;
  }

  static tendon::Result<void> Execute(tendon::GcmClient& client,
                                      const tendon::message::LifecycleOrder& order) {
    return tendon::Wait<void>(2 * kLong,
                              [&](auto handler) { client.ExecuteLifecycleOrder(order, handler); });
  }
  /// Sends an order for a component of the process robot, and waits for the reply.
  tendon::Result<void> Order(tendon::LifecycleVerb verb, const std::string& component) {
    return Execute(*client_, {.verb = verb, .process = "robot", .component = component});
  }
  tendon::Result<void> Load(const std::string& library) {
    return Execute(*client_,
                   {.verb = tendon::LifecycleVerb::kLoad, .process = "robot", .library = library});
  }
  tendon::Result<void> Create(const std::string& class_name, const std::string& component,
                              const std::string& configuration = "") {
    return Execute(*client_, {.verb = tendon::LifecycleVerb::kCreate,
                              .process = "robot",
                              .component = component,
                              .class_name = class_name,
                              .library = "lamps",
                              .configuration = configuration});
  }
  tendon::Result<void> Configure(const std::string& component, const std::string& configuration) {
    return Execute(*client_, {.verb = tendon::LifecycleVerb::kConfigure,
                              .process = "robot",
                              .component = component,
                              .configuration = configuration});
  }
  using Pending = std::future<tendon::Result<void>>;
  /// Sends an order without waiting for the reply.
  Pending OrderLater(const tendon::message::LifecycleOrder& order) {
    auto promise = std::make_shared<std::promise<tendon::Result<void>>>();
    client_->ExecuteLifecycleOrder(order,
                                   [promise](const auto& result) { promise->set_value(result); });
    return promise->get_future();
  }
  Pending OrderLater(tendon::LifecycleVerb verb, const std::string& component) {
    return OrderLater({.verb = verb, .process = "robot", .component = component});
  }
  /// Returns the newest steps of the history, each as "start lamp" with its state.
  [[nodiscard]] std::vector<std::string> Steps() {
    const auto history = tendon::Wait<tendon::message::History>(
        kLong, [&](auto handler) { client_->GetHistory(handler); });
    std::vector<std::string> all;
    for (const auto& one : history->entries) {
      all.push_back(one.verb + " " + one.lifecycle.component + (one.is_unknown ? ", unknown" : ""));
    }
    return all;
  }
  /// Undoes the newest step. Returns its text, or the error if nothing was undone.
  std::string Undone() {
    const auto undone = tendon::Wait<tendon::message::HistoryEntry>(
        3 * kLong, [&](auto handler) { client_->Undo(handler); });
    return undone ? undone->verb + " " + undone->lifecycle.component : undone.error().message;
  }
  /// Returns the reason of a refusal; empty if the order was not refused.
  static std::string Reason(const tendon::Result<void>& result) {
    return result ? std::string() : result.error().message;
  }

  /// Returns the component as the GCM knows it now. Its name is empty if it does not exist.
  [[nodiscard]] tendon::ComponentDescription Known(const std::string& component) {
    const tendon::Catalogue catalogue = gcm().catalogue();
    const auto* found = catalogue.FindComponent("robot", component);
    return found == nullptr ? tendon::ComponentDescription() : *found;
  }

  std::unique_ptr<tendon::Process> robot_;
  std::unique_ptr<tendon::GcmClient> client_;
};
