#include <gtest/gtest.h>
#include <tendon/base/name.h>
#include <tendon/manager/component_loader.h>
#include <tendon/manager/local_manager.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "components/arm_client.h"
#include "support/program.h"

namespace tendon {
namespace {

/// The components of demo.json, all in this process, created from their plug-ins.
class DemoSystem : public testing::Test {
 protected:
  void SetUp() override {
    std::ifstream file(std::string(TENDON_SYSTEMS) + "/demo.json");
    system_ = nlohmann::json::parse(file);
    for (const auto& process : system_["processes"]) {
      for (const auto& component : process["components"]) {
        const auto configuration = component.value("configuration", nlohmann::json());
        const std::string library = component["library"];
        const std::string class_name = component["class"];
        auto made = loader_.Create(library, class_name, component["name"],
                                   configuration.is_null() ? "" : configuration.dump());
        ASSERT_TRUE(made) << made.error().message;
        manager_.Add(std::move(*made), {class_name, library});
      }
    }
  }

  Result<ConnectionId> Connect(const std::string& required, const std::string& provided) {
    auto client = ParseInterfaceName(required);
    auto server = ParseInterfaceName(provided);
    if (!client) return client.error();
    if (!server) return server.error();
    client->process.clear();
    server->process.clear();
    return manager_.Connect(*client, *server);
  }

  nlohmann::json system_;
  ComponentLoader loader_{{Built("lib/tendon/components")}};
  LocalManager manager_;
};

TEST_F(DemoSystem, AllConnectionsCanBeMade) {
  ASSERT_FALSE(system_["connections"].empty());
  for (const auto& connection : system_["connections"]) {
    const auto made = Connect(connection["required"], connection["provided"]);
    EXPECT_TRUE(made) << made.error().message;
  }
}

TEST_F(DemoSystem, TeleoperationConnectsToTheArm) {
  for (const auto& connection : system_["connections"]) {
    EXPECT_NE(connection["required"], "desk/teleoperation/Robot");
  }

  const auto made = Connect("desk/teleoperation/Robot", "robot/arm/Control");

  EXPECT_TRUE(made) << made.error().message;
}

TEST_F(DemoSystem, ConnectingToTheOldArmIsIncompatible) {
  const auto made = Connect("desk/teleoperation/Robot", "desk/old_arm/Control");

  ASSERT_FALSE(made);
  EXPECT_EQ(made.error().code, ErrorCode::kIncompatible);
}

TEST_F(DemoSystem, AllComponentsStart) {
  EXPECT_TRUE(manager_.StartAll());

  for (const auto& component : manager_.components()) {
    EXPECT_EQ(component.state, ComponentState::kActive) << component.name;
  }
}

}  // namespace
}  // namespace tendon
