#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tendon/gcm/interface_matching.h>
#include <tests/core/gcm/samples.h>

namespace tendon {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using Kind = CatalogueChange::Kind;

class Matching : public testing::Test {
 protected:
  void Apply(CatalogueChange change) {
    change.revision = catalogue_.revision() + 1;
    ASSERT_TRUE(catalogue_.Apply(change));
  }
  void Add(const std::string& process, const ComponentDescription& component) {
    if (catalogue_.FindProcess(process) == nullptr) {
      Apply({.kind = Kind::kProcess,
             .process = process,
             .processes = {test::ProcessNamed(process, 1)}});
    }
    Apply({.kind = Kind::kComponent, .process = process, .components = {component}});
  }
  [[nodiscard]] std::vector<Match> Of(const std::string& required,
                                      const std::string& provided) const {
    const auto matches = MatchInterfaces(catalogue_, {required, provided});
    EXPECT_TRUE(matches) << matches.error().message;
    return matches ? *matches : std::vector<Match>();
  }

  Catalogue catalogue_;
};

const InterfaceName kNeed("desk", "teleoperation", "Robot");
const InterfaceName kOffer("robot", "arm", "Control");

TEST_F(Matching, MatchesCompatibleInterfaces) {
  Add("desk", test::Teleoperation());
  Add("robot", test::Arm());
  Add("robot", test::FakeArm());

  const auto matches = Of("desk/**", "robot/**");

  ASSERT_EQ(matches.size(), 1U);
  EXPECT_EQ(matches[0].required, kNeed);
  EXPECT_THAT(matches[0].provided, ElementsAre(kOffer)) << "the other one does not fit";
}

TEST_F(Matching, PrefersTheProviderOfTheSameName) {
  ComponentDescription two = test::Arm();
  two.provided.push_back(test::Control());
  two.provided[1].name = "Robot";
  Add("desk", test::Teleoperation());
  Add("robot", two);

  EXPECT_THAT(Of("**", "**")[0].provided, ElementsAre(InterfaceName("robot", "arm", "Robot")));
  EXPECT_THAT(Of("**", "**/Control")[0].provided, ElementsAre(kOffer));
}

TEST_F(Matching, ListsAllEquallyGoodProviders) {
  Add("desk", test::Teleoperation());
  Add("robot", test::Arm("left"));
  Add("robot", test::Arm("right"));

  EXPECT_THAT(Of("**", "**")[0].provided, ElementsAre(InterfaceName("robot", "left", "Control"),
                                                      InterfaceName("robot", "right", "Control")));
  EXPECT_THAT(Of("**", "robot/left/*")[0].provided,
              ElementsAre(InterfaceName("robot", "left", "Control")));
}

TEST_F(Matching, MatchesNoComponentWithItself) {
  ComponentDescription both = test::Arm("both");
  both.required = {test::Robot()};
  Add("robot", both);

  EXPECT_THAT(Of("**", "**")[0].provided, IsEmpty());
}

TEST_F(Matching, OmitsConnectedInterfaces) {
  Add("desk", test::Teleoperation());
  Add("robot", test::Arm());
  Apply({.kind = Kind::kConnection,
         .process = "desk",
         .connections = {{.id = 1, .required = kNeed, .provided = kOffer}}});

  EXPECT_THAT(Of("**", "**"), IsEmpty());
}

TEST_F(Matching, OmitsAbsentProcesses) {
  Add("desk", test::Teleoperation());
  Add("robot", test::Arm());
  auto lost = catalogue_.FindProcess("robot")->process;
  lost.state = ProcessState::kLost;
  Apply({.kind = Kind::kProcess, .process = "robot", .processes = {lost}});

  const auto matches = MatchInterfaces(catalogue_, {"**", "robot/**"});

  ASSERT_FALSE(matches);
  EXPECT_EQ(matches.error().code, ErrorCode::kNotFound);
  EXPECT_EQ(matches.error().message,
            "no provided interface matches 'robot/**'; to list all names: gcm ls -R");
}

}  // namespace
}  // namespace tendon
