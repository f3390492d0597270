#include <gcm_gui/diagnosis/diagnosis_report.h>
#include <gtest/gtest.h>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

const InterfaceName kReported{"desk", "teleoperation", "Robot"};
const InterfaceName kController{"robot", "controller", "Control"};

class DiagnosisReportTest : public ::testing::Test {
 protected:
  DiagnosisReport Report(const InterfaceName& required, const InterfaceName& provided) {
    return {*Diagnose(system_.catalogue(), {required, provided}), std::nullopt, {}};
  }

  SystemBuilder system_ = LookSystem(0);
  RefusedConnections refusals_;
};

TEST_F(DiagnosisReportTest, TheVerdictNamesTheFailedStep) {
  EXPECT_EQ(Report(kReported, kController).verdict(), "nothing prevents the connection");
  EXPECT_EQ(Report(kReported, {"robot", "arm", "Drives"}).verdict(), "fails at step 4 of 7");
  EXPECT_EQ(Report(kReported, {"vision", "camera", "Video"}).verdict(), "fails at step 1 of 7");
}

TEST_F(DiagnosisReportTest, TheTextMatchesTheConsole) {
  const QString text = Report(kReported, {"robot", "arm", "Drives"}).text();

  EXPECT_TRUE(text.contains("  1 ok  processes desk and robot are available\n"))
      << text.toStdString();
  EXPECT_TRUE(text.contains("  5 -   the processes reach each other\n")) << text.toStdString();
  EXPECT_TRUE(text.contains("gcm explain desk/teleoperation/Robot robot/arm/Drives\n"));
}

TEST_F(DiagnosisReportTest, CopiesTheCommandOfAFix) {
  EXPECT_EQ(CommandOfFix("to list the compatible interfaces: gcm candidates a/b/C"),
            "gcm candidates a/b/C");
  EXPECT_EQ(CommandOfFix("start the component again"), "start the component again");
}

TEST_F(DiagnosisReportTest, PrefersTheRefusedThenTheConnectedThenTheBestProvider) {
  EXPECT_EQ(LikelyProvider(system_.catalogue(), refusals_, kReported), kController);

  system_.Connect(kReported, {"robot", "arm", "Drives"}, ConnectionState::kFailed);
  EXPECT_EQ(LikelyProvider(system_.catalogue(), refusals_, kReported),
            (InterfaceName{"robot", "arm", "Drives"}));

  Action refused;
  refused.required = kReported;
  refused.provided = kController;
  refused.outcome = Action::Outcome::kRefused;
  refusals_.onActionFinished(refused);
  EXPECT_EQ(LikelyProvider(system_.catalogue(), refusals_, kReported), kController);
}

}  // namespace
}  // namespace tendon::gui
