#include <gtest/gtest.h>
#include <tendon/manager/component_loader.h>

#include <string>

#include "support/program.h"

namespace tendon {
namespace {

struct Plugin {
  std::string library;
  std::string class_name;
};

class PluginTest : public testing::TestWithParam<Plugin> {
 protected:
  ComponentLoader loader_{{Built("lib/tendon/components")}};
};

TEST_P(PluginTest, CreatesAComponentOfItsClass) {
  const auto component = loader_.Create(GetParam().library, GetParam().class_name, "one", "");

  ASSERT_TRUE(component) << component.error().message;
  EXPECT_EQ((*component)->name(), "one");
  EXPECT_GT((*component)->period(), 0.0);
}

TEST_P(PluginTest, RejectsAnUnknownConfigurationField) {
  const auto component =
      loader_.Create(GetParam().library, GetParam().class_name, "one", R"({"colour": "red"})");

  ASSERT_FALSE(component);
  EXPECT_EQ(component.error().code, ErrorCode::kInvalid) << component.error().message;
  EXPECT_NE(component.error().message.find("colour"), std::string::npos)
      << component.error().message;
}

INSTANTIATE_TEST_SUITE_P(
    Each, PluginTest,
    testing::Values(Plugin{"arm_supervisor", "ArmSupervisor"}, Plugin{"counter", "Counter"},
                    Plugin{"counter", "CounterClient"}, Plugin{"host_monitor", "HostMonitor"},
                    Plugin{"legacy_arm", "LegacyArm"}, Plugin{"recorder", "Recorder"},
                    Plugin{"simulated_arm", "SimulatedArm"},
                    Plugin{"teleoperation", "Teleoperation"}),
    [](const auto& test) { return test.param.library + test.param.class_name; });

TEST(SimulatedArmPlugin, AcceptsAPartialConfiguration) {
  ComponentLoader loader({Built("lib/tendon/components")});

  EXPECT_TRUE(loader.Create("simulated_arm", "SimulatedArm", "arm", R"({"noise": 0.001})"));
}

TEST(SimulatedArmPlugin, ReportsConfigurationErrors) {
  ComponentLoader loader({Built("lib/tendon/components")});

  const auto refusal = [&loader](const std::string& configuration) {
    const auto arm = loader.Create("simulated_arm", "SimulatedArm", "arm", configuration);
    return arm ? "" : arm.error().message;
  };

  EXPECT_EQ(refusal(R"({"noise": -1})"),
            "component 'arm' (class SimulatedArm): noise: expected a number from 0 to 1 (rad), got "
            "number -1 (plug-in simulated_arm.so)");
  EXPECT_EQ(refusal(R"({"bandwidth": 0})"),
            "component 'arm' (class SimulatedArm): bandwidth: expected a number from 0.001 to 500 "
            "(rad/s), got number 0 (plug-in simulated_arm.so)");
  EXPECT_EQ(refusal(R"({"home": [3, 0, 0, -1, 0, 0, 0]})"),
            "component 'arm' (class SimulatedArm): its constructor failed: configuration of 'arm': "
            "home[0] is 3, expected -2.8973 to 2.8973 rad, the lower and the upper limit of this "
            "joint (plug-in simulated_arm.so)");
}

}  // namespace
}  // namespace tendon
