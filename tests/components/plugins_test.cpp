#include <gtest/gtest.h>
#include <tendon/manager/component_loader.h>

#include <string>

namespace tendon {
namespace {

struct Plugin {
  std::string library;
  std::string class_name;
};

class PluginTest : public testing::TestWithParam<Plugin> {
 protected:
  ComponentLoader loader_{{TENDON_PLUGINS}};
};

TEST_P(PluginTest, IsLoadedAndMakesAComponentOfItsClass) {
  const auto component = loader_.Create(GetParam().library, GetParam().class_name, "one", "");

  ASSERT_TRUE(component) << component.error().message;
  EXPECT_EQ((*component)->name(), "one");
  EXPECT_GT((*component)->period(), 0.0);
}

TEST_P(PluginTest, RefusesAConfigurationThatItDoesNotKnow) {
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
                    Plugin{"legacy_arm", "LegacyArm"}, Plugin{"simulated_arm", "SimulatedArm"},
                    Plugin{"teleoperation", "Teleoperation"}),
    [](const auto& test) { return test.param.library + test.param.class_name; });

TEST(SimulatedArmPlugin, TakesAConfigurationThatNamesWhatDiffersFromTheDefaults) {
  ComponentLoader loader({TENDON_PLUGINS});

  EXPECT_TRUE(loader.Create("simulated_arm", "SimulatedArm", "arm", R"({"noise": 0.001})"));
}

TEST(SimulatedArmPlugin, SaysWhatIsWrongWithItsConfiguration) {
  ComponentLoader loader({TENDON_PLUGINS});

  const auto arm = loader.Create("simulated_arm", "SimulatedArm", "arm", R"({"noise": -1})");

  ASSERT_FALSE(arm);
  EXPECT_EQ(arm.error().message,
            "component 'arm' (class SimulatedArm): its constructor failed: configuration of 'arm': "
            "noise is -1.000000, expected 0 to 1 rad (plug-in simulated_arm.so)");
}

}  // namespace
}  // namespace tendon
