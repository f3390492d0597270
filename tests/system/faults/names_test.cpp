#include <algorithm>

#include "system/faults/harness/fault_test.h"

namespace faults {
namespace {

using tendon::ProcessState;
using testing::HasSubstr;

class Names : public FaultTest {
 protected:
  using Programs = std::vector<std::unique_ptr<Program>>;

  /// Waits until all programs except one have ended. Returns the number of running programs.
  static std::ptrdiff_t Survivors(Programs& programs) {
    std::ptrdiff_t alive = 0;
    const auto count = [&] {
      alive = std::count_if(programs.begin(), programs.end(), [](const auto& program) {
        return !program->Wait(std::chrono::seconds(0));
      });
      return alive <= 1;
    };
    Eventually(count);
    return alive;
  }
};

INSTANTIATE_TEST_SUITE_P(Over, Names, testing::ValuesIn(Middlewares()), NameOfMiddleware);

TEST_P(Names, ExactlyOneOfManySimultaneousLcmsGetsTheName) {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  ASSERT_NO_FATAL_FAILURE(StartViewer());
  const int count = Size(8, 100);
  Programs lcms;
  for (int i = 0; i < count; ++i) lcms.push_back(MakeLcm("robot"));

  const auto survivors = Survivors(lcms);
  if (MayExpireLeases() && watch_->Count("robot", ProcessState::kLost) > 0) {
    GTEST_SKIP() << "the one that won was lost meanwhile";
  }
  EXPECT_EQ(survivors, 1);

  ASSERT_TRUE(EventuallyIs("robot", ProcessState::kAlive));
  const auto catalogue = viewer_->catalogue();
  const auto holder = catalogue.FindProcess("robot")->process.pid;
  for (const auto& lcm : lcms) {
    const auto exit_code = lcm->Wait(std::chrono::seconds(0));
    EXPECT_EQ(exit_code.has_value(), lcm->pid() != holder);
    if (!exit_code) continue;
    EXPECT_EQ(*exit_code, 1) << lcm->err();
    EXPECT_THAT(lcm->err(), HasSubstr("process name 'robot' is in use"));
    EXPECT_THAT(lcm->err(), HasSubstr("pid " + std::to_string(holder)));
  }
  Tell(std::to_string(count) + " at once, one won");
  ExpectNeverLost("robot");
}

TEST_P(Names, LateDuplicatesDoNotDisturbTheFirstLcm) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());
  Programs late;
  for (int i = 0; i < Size(4, 50); ++i) late.push_back(MakeLcm("robot"));

  for (const auto& lcm : late) EXPECT_EQ(lcm->Wait(std::chrono::seconds(120)), 1) << lcm->err();

  ASSERT_TRUE(Flows());
  ExpectNoRowLost();
  ExpectNeverLost("robot");
  ExpectHonestCommands();
}

TEST_P(Names, ExactlyOneOfManySimultaneousGcmsServes) {
  Programs gcms;
  for (int i = 0; i < Size(6, 50); ++i) gcms.push_back(MakeGcm());

  ASSERT_EQ(Survivors(gcms), 1);

  const auto winner = std::find_if(gcms.begin(), gcms.end(), [](const auto& gcm) {
    return !gcm->Wait(std::chrono::seconds(0));
  });
  ASSERT_TRUE(Eventually([&] { return (*winner)->out().starts_with("GCM at "); }));
  for (const auto& gcm : gcms) {
    if (gcm == *winner) continue;
    EXPECT_EQ(gcm->Wait(), 1);
    EXPECT_THAT(gcm->err(), HasSubstr(gcm_address_ + " is in use by"));
    EXPECT_THAT(gcm->err(), HasSubstr("use the running GCM"));
  }
  gcm_ = std::move(*winner);
  EXPECT_EQ(Gcm({"ls"}).exit_code, 0);
}

TEST_P(Names, ASecondGcmDoesNotDisturbTheFirst) {
  ASSERT_NO_FATAL_FAILURE(StartSystem());

  const auto second = MakeGcm();

  EXPECT_EQ(second->Wait(), 1) << second->err();
  EXPECT_THAT(second->err(), HasSubstr("pid " + std::to_string(gcm_->pid()) + " (gcm)"));
  ASSERT_TRUE(Flows());
  ExpectNoRowLost();
  ExpectNeverLost("robot");
  ExpectHonestCommands();
}

}  // namespace
}  // namespace faults
