#include <gcm_gui/call/call_panel.h>
#include <gmock/gmock.h>
#include <tests/core/gcm/argument_samples.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "support/fakes.h"

namespace tendon::gui {
namespace {

using test::MemberOf;

/// A form whose read command has another type than the argument, like MoveTo of the demo.
class FormDefaultsTest : public ::testing::Test {
 protected:
  FormDefaultsTest() {
    calls_.schema = test::JointGoalSchema(2);
    calls_.schemas[FingerprintOf<double>()] = test::JointStateSchema(2);
    calls_.schemas[FingerprintOf<float>()] = test::Numbers(2);
    panel_.resize(312, 400);
  }

  void Open() {
    panel_.showCommand("robot/arm/Control.MoveTo", MemberOf("MoveTo", CommandKind::kWrite),
                       {{.name = "GetTool", .type = FingerprintOf<float>(), .is_whole = false},
                        {.name = "GetJoints", .type = FingerprintOf<double>(), .is_whole = false}});
    panel_.show();
  }
  QString Status() { return panel_.findChild<QLabel*>("call.status")->text(); }

  ScriptedCalls calls_;
  CallPanel panel_{calls_};
};

TEST_F(FormDefaultsTest, StartsWithTheCurrentPosition) {
  Open();
  ASSERT_EQ(calls_.read, QStringList{"robot/arm/Control.GetJoints"});

  calls_.value(std::string(R"({"position":[0.1,-1.5],"velocity":[3,4]})"));

  EXPECT_EQ(Status(), "position: current values from GetJoints");
  QTest::mouseClick(panel_.findChild<QPushButton*>("call.call"), Qt::LeftButton);
  ASSERT_EQ(calls_.calls.size(), 1);
  EXPECT_THAT(calls_.calls[0].toStdString(), testing::HasSubstr(R"("position":[0.1,-1.5])"));
}

TEST_F(FormDefaultsTest, ReportsThatItsValuesAreNotCurrent) {
  Open();

  calls_.value(Error{ErrorCode::kTimeout, "no reply"});

  EXPECT_EQ(Status(),
            "These are not the current values: GetJoints does not report the current values");
}

}  // namespace
}  // namespace tendon::gui
