#include <gcm_gui/models/text.h>
#include <gcm_gui/plot/controls/legend.h>
#include <gcm_gui/plot/plot_panel.h>
#include <gcm_gui/plot/plot_view.h>
#include <gcm_gui/window/audit_line.h>
#include <gcm_gui/window/mark_binding.h>
#include <gmock/gmock.h>

#include <QTest>
#include <chrono>

#include "support/fakes.h"
#include "support/sample_system.h"

namespace tendon::gui {
namespace {

std::int64_t SteadyTime() {
  return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

const QString kMarkedSignal = QStringLiteral("robot/arm/state.Joints.position[0]");

class MarkBindingTest : public testing::Test {
 protected:
  MarkBindingTest() { Tell(); }

  void Tell() { store_.apply(system_.TakeChanges()); }
  [[nodiscard]] QStringList labels() const {
    QStringList labels;
    for (const Mark& mark : panel_.marks().all()) labels << mark.label;
    return labels;
  }
  void Finish(Action action, const QString& refusal) {
    activity_.finish(activity_.begin(std::move(action)), 0.01, refusal);
  }

  void raise(const QString& path, std::int64_t when = WallClock()) {
    Q_EMIT reports_.eventsArrived({{when, path, "{\"joint\": 2}"}});
  }
  /// Sends a line of robot's audit log.
  void sent(const std::string& what, bool is_current) {
    LogBatch batch{.is_current = is_current};
    batch.records.push_back({.time = WallClock(),
                             .process = "robot",
                             .source = "audit",
                             .text = "desk (operator, 10.0.0.7:1): call a command " + what});
    Q_EMIT reports_.logArrived(batch);
  }

  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  ActivityModel activity_;
  PlotPanel panel_;
  ScriptedReports reports_;
  MarkBinding binding_{panel_, store_, activity_, reports_};
  const InterfaceName required_{"desk", "teleoperation", "Robot"};
  const InterfaceName provided_{"robot", "controller", "Control"};
};

TEST_F(MarkBindingTest, TheInitialStateMakesNoMarks) { EXPECT_TRUE(labels().isEmpty()); }

TEST_F(MarkBindingTest, MarksConnectionsMadeByAnyProgram) {
  system_.Connect(required_, provided_);
  Tell();
  system_.Disconnect(required_);
  Tell();

  EXPECT_EQ(labels(), (QStringList{"teleoperation connected", "teleoperation disconnected"}));
  EXPECT_FALSE(panel_.marks().all().back().is_bad);
}

TEST_F(MarkBindingTest, MarksStateChangesAndFaults) {
  ComponentDescription arm = *system_.catalogue().FindComponent("robot", "arm");
  arm.state = ComponentState::kFaulted;
  arm.fault = "too hot";
  system_.Component("robot", arm);
  Tell();

  ASSERT_EQ(labels(), QStringList{"arm faulted"});
  EXPECT_TRUE(panel_.marks().all().back().is_bad);
  EXPECT_EQ(panel_.marks().all().back().text, "robot/arm is faulted: too hot");
}

TEST_F(MarkBindingTest, MarksALostAndReturnedProcess) {
  system_.Process("robot", ProcessState::kLost, 1);
  Tell();
  EXPECT_TRUE(labels().contains("robot lost"));
  system_.Process("robot", ProcessState::kAlive, 2, 2);
  Tell();
  EXPECT_TRUE(labels().contains("robot is back"));
}

TEST_F(MarkBindingTest, MarksCallsAndRefusals) {
  const std::int64_t before = SteadyTime();
  Action call;
  call.verb = Action::Verb::kCall;
  call.command = "robot/arm/Control.MoveTo";
  call.argument = "{\"x\": 1}";
  Finish(call, {});
  Finish(call, "not now");

  ASSERT_EQ(labels(), (QStringList{"MoveTo", "MoveTo"}));
  const Mark& first = panel_.marks().all().front();
  EXPECT_EQ(first.text, "call robot/arm/Control.MoveTo {\"x\": 1}");
  EXPECT_FALSE(first.is_bad);
  EXPECT_TRUE(panel_.marks().all().back().is_bad);
  constexpr std::int64_t kClocksApart = 60'000'000'000;  // ns
  EXPECT_GE(first.time_ns, before - kClocksApart);
}

TEST_F(MarkBindingTest, MarksOnlyEventsOfPlottedComponents) {
  EXPECT_TRUE(reports_.listened().isEmpty());
  panel_.addSignal(kMarkedSignal, "rad");
  EXPECT_EQ(reports_.listened(), QStringList{"robot/arm/*"});

  raise("robot/arm/Control.LimitExceeded");
  raise("robot/sensor/Control.TooHot");
  ASSERT_EQ(labels(), QStringList{"LimitExceeded"});
  EXPECT_EQ(panel_.marks().all().back().kind, Mark::Kind::kEvent);
  EXPECT_EQ(panel_.marks().all().back().text, "robot/arm/Control.LimitExceeded {\"joint\": 2}");

  QTest::keyClick(panel_.currentPlot().legendBox().rows().front(), Qt::Key_Delete);
  EXPECT_TRUE(reports_.listened().isEmpty());
}

TEST_F(MarkBindingTest, HiddenMarksNeedNoEventSubscription) {
  panel_.addSignal(kMarkedSignal, "rad");

  panel_.setMarksShown(false);
  EXPECT_TRUE(reports_.listened().isEmpty());

  panel_.setMarksShown(true);
  EXPECT_EQ(reports_.listened().size(), 1);
}

TEST_F(MarkBindingTest, LimitsTheNumberOfEventSubscriptions) {
  for (int i = 0; i < 40; ++i) panel_.addSignal(QString("robot/c%1/state.x").arg(i), "rad");

  EXPECT_EQ(reports_.listened().size(), MarkBinding::kMaxListenedTo);
}

TEST_F(MarkBindingTest, CombinesFrequentEventsIntoOneMark) {
  panel_.addSignal(kMarkedSignal, "rad");
  const std::int64_t now = WallClock();
  for (int i = 0; i < 10; ++i) raise("robot/arm/Control.Tick", now + i * 1'000'000);
  raise("robot/arm/Control.Tick", now + MarkBinding::kEventPauseNs);

  ASSERT_EQ(labels().size(), 2);
  EXPECT_THAT(panel_.marks().all().back().text.toStdString(), testing::HasSubstr("9 more"));
}

TEST_F(MarkBindingTest, MarksAuditedCommandsOfOtherPrograms) {
  panel_.addSignal(kMarkedSignal, "rad");
  ASSERT_TRUE(reports_.watches_log);
  sent("before this window watched", false);
  sent("arm/Control.MoveTo: allowed", true);  // new records come after this old one
  sent("arm/Control.MoveTo: allowed", true);
  sent("arm/Control.Stop: refused", true);

  ASSERT_EQ(labels(), (QStringList{"MoveTo", "Stop"}));
  const Mark& mark = panel_.marks().all().front();
  EXPECT_EQ(mark.kind, Mark::Kind::kCommand);
  EXPECT_EQ(mark.text, "call robot/arm/Control.MoveTo by desk (operator, 10.0.0.7:1)");
  EXPECT_TRUE(panel_.marks().all().back().is_bad);
}

/// A form of this or another window requests its initial values. No user has called a command.
TEST_F(MarkBindingTest, DoesNotMarkReadCommands) {
  panel_.addSignal(kMarkedSignal, "rad");
  sent("nothing", true);

  sent("controller/Control.GetJoints: allowed", true);
  sent("arm/Control.Stop: allowed", true);

  EXPECT_EQ(labels(), QStringList{"Stop"});
}

TEST_F(MarkBindingTest, MarksACallOfThisWindowOnce) {
  panel_.addSignal(kMarkedSignal, "rad");
  sent("nothing", true);
  Action call;
  call.verb = Action::Verb::kCall;
  call.command = "robot/arm/Control.MoveTo";
  call.when = WallClock();
  const auto id = activity_.begin(call);

  sent("arm/Control.MoveTo: allowed", true);
  activity_.finish(id, 0.01, {});

  EXPECT_EQ(labels(), QStringList{"MoveTo"});
}

TEST(SentCommand, IsParsedFromAnAuditRecord) {
  message::LogRecord record{.process = "robot", .source = "audit"};
  const auto path_of = [&](const char* text) {
    record.text = text;
    const auto sent = SentCommandOf(record);
    return sent ? sent->path : QString();
  };

  EXPECT_EQ(path_of("desk (viewer, [::1]:7): call a command a/B.C: refused"), "robot/a/B.C");
  EXPECT_EQ(path_of("x: call a command no: allowed (operator, y): call a command a/B.C: allowed"),
            "robot/a/B.C");
  EXPECT_EQ(path_of("desk (operator, y): connect a b: allowed"), QString());
  EXPECT_EQ(path_of("desk (operator, y): call a command : allowed"), QString());
  EXPECT_EQ(path_of("and 12 more of one program"), QString());
  record.source = "arm";
  EXPECT_EQ(path_of("desk (operator, y): call a command a/B.C: allowed"), QString());
}

}  // namespace
}  // namespace tendon::gui
