#include <gmock/gmock.h>
#include <tendon/gcm/lookup.h>
#include <tendon/gcm/system/plan.h>
#include <tests/core/gcm/system/running_catalogue.h>

namespace tendon {
namespace {

using test::CatalogBuilder;
using test::TextsOf;
using testing::ElementsAre;

/// Returns the step that has started this process of the catalogue.
PlanStep BirthOf(const CatalogBuilder& running, const std::string& process,
                 RestartPolicy restart = RestartPolicy::kOnFailure) {
  return {.kind = PlanStep::Kind::kStartProcess,
          .process = process,
          .instance = InstanceOf(running.catalogue(), process),
          .restart = restart};
}

TEST(WithEnds, EndsPresentProcessesOfTheOtherSystem) {
  CatalogBuilder running;
  running.Process("desk", {}).Process("robot", {}, ProcessState::kLeft);

  const Plan plan = WithEnds(
      {}, running.catalogue(),
      {BirthOf(running, "robot"), BirthOf(running, "desk"), BirthOf(running, "never_there")});

  EXPECT_THAT(TextsOf(plan), ElementsAre("end process desk"));
  EXPECT_EQ(plan.steps[0].instance, InstanceOf(running.catalogue(), "desk"));
  EXPECT_EQ(plan.steps[0].restart, RestartPolicy::kOnFailure);
  EXPECT_TRUE(plan.TakesAway());
}

TEST(WithEnds, EndsNoRestartedProcess) {
  CatalogBuilder running;
  running.Process("desk", {}).Process("robot", {});
  const std::vector<PlanStep> births = {BirthOf(running, "desk"), BirthOf(running, "robot")};
  running.Process("desk", {});

  EXPECT_THAT(TextsOf(WithEnds({}, running.catalogue(), births)), ElementsAre("end process robot"));
}

TEST(WithEnds, EndsALostProcessThatMayBeRestarted) {
  CatalogBuilder running;
  running.Process("desk", {}, ProcessState::kLost).Process("robot", {}, ProcessState::kLost);

  const Plan plan = WithEnds({}, running.catalogue(),
                             {BirthOf(running, "desk", RestartPolicy::kOnFailure),
                              BirthOf(running, "robot", RestartPolicy::kNever)});

  EXPECT_THAT(TextsOf(plan), ElementsAre("end process desk"));
}

}  // namespace
}  // namespace tendon
