#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/manager/component_loader.h>

#include <filesystem>
#include <fstream>

#include "support/folder.h"

namespace tendon_test {

struct GripperConfiguration {
  double force = 10.0;
  std::string side = "left";
};

class Gripper final : public tendon::Component {
 public:
  using Configuration = GripperConfiguration;
  Gripper(std::string name, const Configuration& chosen)
      : Component(std::move(name)), configuration(chosen) {
    if (configuration.force < 0) throw std::runtime_error("force must not be negative");
  }
  Configuration configuration;
};

class Plain final : public tendon::Component {
 public:
  explicit Plain(std::string name) : Component(std::move(name)) {}
};

}  // namespace tendon_test

template <>
inline constexpr auto tendon::kPayload<tendon_test::GripperConfiguration> =
    tendon::Describe("test.GripperConfiguration",
                     tendon::Field{"force", &tendon_test::GripperConfiguration::force, "N"},
                     tendon::Field{"side", &tendon_test::GripperConfiguration::side});

namespace tendon_test {
namespace {

using tendon::ErrorCode;
using testing::HasSubstr;
namespace fs = std::filesystem;

struct ComponentRegistryTest : testing::Test {
  ComponentRegistryTest() {
    registry.Add<Gripper>("Gripper");
    registry.Add<Plain>("Plain");
  }
  std::string Refusal(const std::string& class_name, const std::string& json) const {
    const auto created = registry.Create(class_name, "hand", json);
    return created ? "created" : created.error().message;
  }
  tendon::ComponentRegistry registry;
};

TEST_F(ComponentRegistryTest, MergesDefaultsWithTheGivenConfiguration) {
  const auto created = registry.Create("Gripper", "hand", R"({"force": 2.5})");

  ASSERT_TRUE(created.ok()) << created.error().message;
  const auto& gripper = dynamic_cast<const Gripper&>(**created);
  EXPECT_EQ(gripper.configuration.force, 2.5);
  EXPECT_EQ(gripper.configuration.side, "left");
}

TEST_F(ComponentRegistryTest, RefusalsNameTheComponentAndTheReason) {
  EXPECT_EQ(Refusal("Griper", ""), "no component class 'Griper'; did you mean 'Gripper'?");
  EXPECT_THAT(Refusal("Gripper", R"({"forse": 1})"), HasSubstr("'forse'"));
  EXPECT_THAT(Refusal("Gripper", R"({"force": "much"})"), HasSubstr("force"));
  EXPECT_THAT(Refusal("Gripper", "[1]"), HasSubstr("must be a JSON object"));
  EXPECT_EQ(Refusal("Gripper", R"({"force": -1})"),
            "component 'hand' (class Gripper): its constructor failed: force must not be negative");
  EXPECT_THAT(Refusal("Plain", "{}"), HasSubstr("takes no configuration"));
}

TEST_F(ComponentRegistryTest, AClassRegisteredTwiceIsRefused) {
  EXPECT_THROW(registry.Add<Plain>("Plain"), tendon::ConfigurationError);
}

struct ComponentLoaderTest : testing::Test {
  std::string Refusal(const std::string& library) {
    const auto loaded = loader.Load(library);
    return loaded ? "loaded" : loaded.error().message;
  }
  const tendon::test::Folder temporary;
  const fs::path& folder = temporary.path();
  tendon::ComponentLoader loader{{folder}};
};

TEST_F(ComponentLoaderTest, AMissingLibraryIsReportedWithASuggestion) {
  std::ofstream(folder / "gripper.so") << "";

  const std::string refusal = Refusal("griper");

  EXPECT_THAT(refusal, HasSubstr("no plug-in 'griper'; did you mean 'gripper'?"));
  EXPECT_THAT(refusal, HasSubstr(folder.string()));
}

TEST_F(ComponentLoaderTest, RefusesAPathAsALibraryName) {
  EXPECT_THAT(Refusal("../gripper"), HasSubstr("allowed: letters digits _ -"));
}

TEST_F(ComponentLoaderTest, RefusesAFileThatIsNotALibrary) {
  std::ofstream(folder / "text.so") << "this is no library";

  EXPECT_THAT(Refusal("text"), HasSubstr("text.so: expected a shared library for "));
}

}  // namespace
}  // namespace tendon_test
