#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/task/scripted.h"
#include "support/refusal.h"
#include "support/wait.h"

namespace {

using tendon::Status;
using tendon::test::Refusal;
using tendon_test::Periodic;
using testing::HasSubstr;
using testing::MatchesRegex;
using namespace std::chrono_literals;

class Named final : public tendon::Component {
 public:
  Named(std::string name, std::string interface) : Component(std::move(name)) {
    AddProvidedInterface(std::move(interface));
    AddRequiredInterface("Other");
  }
  void Zero(double& out) const { out = 0.0; }
  void AddNow() { AddProvidedInterface("Late"); }
  void AddNowRequired() { AddRequiredInterface("Late"); }
};

TEST(Component, RefusesInvalidNames) {
  const auto named = [](const std::string& name) {
    return Refusal([&] { Named(name, "Control"); });
  };
  const std::string rule = "; allowed: letters digits _ - (max 64)";

  EXPECT_EQ(named(""), "component name is empty");
  EXPECT_EQ(named("a b"), "component name 'a b' has ' ' at 2" + rule);
  EXPECT_EQ(named("a/b"), "component name 'a/b' has '/' at 2" + rule);
  EXPECT_EQ(named("a\n"), "component name 'a\\x0a' has '\\x0a' at 2" + rule);
  EXPECT_EQ(named("\xff"), "component name '\\xff' has '\\xff' at 1" + rule);
  EXPECT_THAT(named(std::string(300, 'a')), HasSubstr("has 300 characters" + rule));
  EXPECT_NO_THROW(Named("arm-1_B", "Control"));
}

TEST(Component, RefusesInvalidInterfaceNames) {
  const auto with = [](const std::string& name) { return Refusal([&] { Named("arm", name); }); };

  EXPECT_THAT(with("state"), HasSubstr("belong to state tables"));
  EXPECT_THAT(with("state-x"), HasSubstr("belong to state tables"));
  EXPECT_THAT(with("a b"), HasSubstr("provided interface name 'a b' has ' ' at 2"));
  EXPECT_THAT(with(""), HasSubstr("provided interface name is empty"));
}

TEST(Component, RefusesADuplicateInterfaceNamingTheFirst) {
  EXPECT_THAT(Refusal([] { Named("arm", "Other"); }),
              MatchesRegex("interface 'Other' already exists in 'arm' "
                           "\\(added at component_test\\.cpp:[0-9]+\\)"));
}

TEST(Component, RefusesAdditionsWhileRunning) {
  tendon::LocalManager manager;
  auto& late = manager.Add<Named>("late", "Control");
  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_EQ(Refusal([&] { late.AddNow(); }),
            "cannot add provided interface 'Late' to component 'late' (state active): add it in "
            "the constructor");
  EXPECT_THAT(Refusal([&] { late.AddNowRequired(); }), HasSubstr("(state active)"));
  EXPECT_THAT(Refusal([&] {
                late.FindProvided("Control")->AddCommandRead(&Named::Zero, &late, "Zero",
                                                             tendon::kThreadSafe);
              }),
              HasSubstr("cannot add command 'Zero' to interface 'Control'"));
}

TEST(Task, ItsTableIsAnInterfaceWithOneReadPerColumn) {
  class Viewer final : public tendon::Component {
   public:
    explicit Viewer(std::string name) : Component(std::move(name)) {
      auto& state = AddRequiredInterface("State");
      state.AddFunction(runs, "Runs");
      state.AddFunction(cycle, "Cycle");
      state.AddFunction(summary, "CycleSummary");
    }
    tendon::ReadFunction<std::uint64_t> runs;
    tendon::ReadFunction<tendon::CycleStatistics> cycle;
    tendon::ReadFunction<tendon::CycleSummary> summary;
  };
  tendon::LocalManager manager;
  manager.Add<Periodic>("task", 1ms);
  auto& viewer = manager.Add<Viewer>("viewer");
  const auto connected = manager.Connect({"viewer", "State"}, {"task", "state"});
  ASSERT_TRUE(connected.ok()) << connected.error().message;
  std::uint64_t runs = 0;
  EXPECT_EQ(viewer.runs(runs), Status::kNoSample);

  ASSERT_TRUE(manager.StartAll().ok());

  EXPECT_TRUE(EventuallyTrue([&] { return viewer.runs(runs) && runs >= 3; }));
  tendon::CycleStatistics cycle;
  EXPECT_EQ(viewer.cycle(cycle), Status::kDone);
  tendon::CycleSummary summary;
  EXPECT_TRUE(EventuallyTrue([&] { return viewer.summary(summary) && summary.cycles > 0; }));
  EXPECT_GE(summary.cycles, 10U);
  EXPECT_GT(summary.period.mean, 0.0);
  EXPECT_GE(summary.period.max, summary.period.p99);
  EXPECT_GE(summary.lateness.min, 0.0);
  EXPECT_GT(summary.compute.max, 0.0);
}

}  // namespace
