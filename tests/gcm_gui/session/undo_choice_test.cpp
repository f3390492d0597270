#include <gcm_gui/session/undo_choice.h>
#include <gtest/gtest.h>

#include <chrono>

namespace tendon::gui {
namespace {

using std::chrono::seconds;

constexpr std::int64_t kWallNow = 1'000'000'000'000;
const UndoChoice::Time kNow{};

message::HistoryEntry Step(std::uint64_t id, const std::string& who) {
  return {.id = id,
          .verb = "connect",
          .ends = {{"desk", "hand", "Robot"}, {"robot", "arm", "Control"}},
          .former = {},
          .lifecycle = {},
          .who = who,
          .when = kWallNow - 12'000'000'000};
}

TEST(UndoChoice, OwnNewestStepIsUndoneAtOnce) {
  UndoChoice choice("me");
  message::History history{{Step(1, "you"), Step(2, "me"), Step(3, "me"), Step(4, "you")}};
  history.entries[2].undone = true;
  history.entries[3].passed_over = true;

  const auto step = choice.Choose(history, kNow, kWallNow);

  ASSERT_TRUE(step.ok()) << step.error().message;
  EXPECT_EQ(*step, 2U);
}

TEST(UndoChoice, RecognisesOwnStepsUnderACertificate) {
  UndoChoice choice("gcm-gui of anna@host");
  EXPECT_TRUE(choice.Choose({{Step(1, "anna (gcm-gui of anna@host)")}}, kNow, kWallNow).ok());
  EXPECT_FALSE(choice.Choose({{Step(2, "bert (gcm-gui of bert@host)")}}, kNow, kWallNow).ok());
}

TEST(UndoChoice, AnothersStepNeedsASecondRequest) {
  UndoChoice choice("me");
  const message::History history{{Step(7, "gcm-gui of anna@host")}};

  const auto asked = choice.Choose(history, kNow, kWallNow);
  ASSERT_FALSE(asked.ok());
  EXPECT_NE(asked.error().message.find("by gcm-gui of anna@host, 12 s ago"), std::string::npos)
      << asked.error().message;

  const auto step = choice.Choose(history, kNow + UndoChoice::kTimeout, kWallNow);
  ASSERT_TRUE(step.ok());
  EXPECT_EQ(*step, 7U);
  EXPECT_FALSE(choice.Choose(history, kNow + UndoChoice::kTimeout, kWallNow).ok()) << "once only";
}

TEST(UndoChoice, TheSecondRequestMustMatchAndComeInTime) {
  UndoChoice choice("me");
  message::History history{{Step(7, "anna")}};
  ASSERT_FALSE(choice.Choose(history, kNow, kWallNow).ok());

  history.entries.push_back(Step(8, "bert"));
  EXPECT_FALSE(choice.Choose(history, kNow + seconds(1), kWallNow).ok()) << "it is another step";
  EXPECT_FALSE(choice.Choose(history, kNow + seconds(2) + UndoChoice::kTimeout, kWallNow).ok())
      << "it is too late";
}

TEST(UndoChoice, StepsThatCauseMotionNeedASecondRequest) {
  UndoChoice choice("me");
  message::History history{{Step(7, "me")}};
  history.entries[0].verb = "stop";
  history.entries[0].lifecycle.process = "robot";
  history.entries[0].lifecycle.component = "arm";

  const auto asked = choice.Choose(history, kNow, kWallNow);

  ASSERT_FALSE(asked.ok());
  EXPECT_NE(asked.error().message.find("can move something"), std::string::npos);
  EXPECT_TRUE(choice.Choose(history, kNow, kWallNow).ok());
}

TEST(UndoChoice, ReportsThatThereIsNothingToUndo) {
  UndoChoice choice("me");

  const auto nothing = choice.Choose({}, kNow, kWallNow);

  ASSERT_FALSE(nothing.ok());
  EXPECT_EQ(nothing.error().message, "there is nothing to undo");
}

}  // namespace
}  // namespace tendon::gui
