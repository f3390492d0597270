#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/system/plan_controller.h>
#include <gcm_gui/system/system_files.h>
#include <gcm_gui/window/notice_line.h>
#include <gtest/gtest.h>
#include <tendon/gcm/lookup.h>

#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "flow/flow_fixture.h"
#include "support/pictures.h"
#include "support/program.h"

namespace tendon::gui {
namespace {

/// At first only a GCM runs. It starts the processes of the demo.
class DemoFlow : public FlowFixture {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(StartGcm());
    ASSERT_NO_FATAL_FAILURE(OpenWindow());
    ASSERT_TRUE(
        Eventually([this] { return session_->link().state() == LinkState::State::kConnected; }));
  }
  /// Ends the processes that the GCM has started; they would outlive the GCM.
  void TearDown() override {
    for (const char* process : {"robot", "desk"}) {
      if (IsEnded(process)) continue;
      const Outcome ended =
          RunProgram({Built("bin/gcm"), "--gcm", address_, "--timeout", "20000", "kill", process},
                     FlowEnvironment());
      EXPECT_EQ(ended.exit_code, 0) << ended.err;
    }
    FlowFixture::TearDown();
  }
  void BringUpDemo() {
    Click(Find<QPushButton>("tryDemo"));
    ASSERT_TRUE(Eventually([this] { return IsDemoRunning(); })) << gcm_->err();
    ASSERT_TRUE(Eventually([this] { return window_->files().restore().canUndo(); }));
  }
  /// Presses Ctrl+S, types the name of the file, and opens the page that compares.
  void Save(const QString& file) {
    QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(Eventually([this] { return window_->findChild<QFileDialog*>() != nullptr; }));
    auto* name = window_->findChild<QFileDialog*>()->findChild<QLineEdit*>("fileNameEdit");
    name->setText(file);
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(Eventually([this] { return window_->files().document().isOpen(); }));
    ClickTab("centre.tabs", "Diff");
  }
  void ClickWhenReady(const char* name) {
    auto& button = Find<QPushButton>(name);
    ASSERT_TRUE(Eventually([&] { return button.isVisible() && button.isEnabled(); })) << name;
    Click(button);
  }
  [[nodiscard]] bool IsAsSaved() const {
    return window_->files().document().comparison().differences.empty();
  }
  [[nodiscard]] QString File() const {
    return QString::fromStdString((home_.path() / "demo.gcm.json").string());
  }
  [[nodiscard]] bool IsEnded(const char* process) const {
    const ProcessEntry* entry = session_->store().catalogue().FindProcess(process);
    return entry == nullptr || !IsPresent(entry->process);
  }
};

TEST_F(DemoFlow, OneClickStartsTheDemo) {
  Click(Find<QPushButton>("tryDemo"));

  EXPECT_TRUE(Eventually([this] { return IsDemoRunning(); })) << gcm_->err();
  EXPECT_TRUE(Eventually([this] {
    return window_->findChild<NoticeLine*>()->text().startsWith("The demo runs");
  })) << window_->findChild<NoticeLine*>()->text().toStdString();
  EXPECT_TRUE(window_->graph().isVisible());
  KeepPictures(*window_, "flow-demo");
}

TEST_F(DemoFlow, TheSavedFileStartsTheProcesses) {
  ASSERT_NO_FATAL_FAILURE(BringUpDemo());

  ASSERT_NO_FATAL_FAILURE(Save(File()));
  KeepPictures(*window_, "flow-saved");

  const auto saved = ReadSystemFile(File().toStdString());
  ASSERT_TRUE(saved.ok());
  for (const char* process : {"robot", "desk"}) {
    ASSERT_NE(saved->FindProcess(process), nullptr) << process;
    EXPECT_TRUE(saved->FindProcess(process)->start.has_value()) << process;
  }
}

TEST_F(DemoFlow, ExternalChangesAreShownRestoredAndUndone) {
  ASSERT_NO_FATAL_FAILURE(BringUpDemo());
  ASSERT_NO_FATAL_FAILURE(Save(File()));
  // Leaves the plan that has started the demo.
  ASSERT_NO_FATAL_FAILURE(ClickWhenReady("plan.back"));
  ASSERT_TRUE(Eventually([this] { return IsAsSaved(); }));
  for (const Program::Words& change :
       {Program::Words{"disconnect", "desk/supervisor/Robot"}, {"rm", "robot/host_monitor"}}) {
    ASSERT_EQ(StartGcmVerb(change)->Wait(), 0) << change.front();
  }
  const auto is_restored = [this] { return IsDemoRunning() && IsAsSaved(); };
  ASSERT_TRUE(Eventually([&] { return !is_restored(); }));
  EXPECT_TRUE(Eventually([this] {
    return Find<QLabel>("diff.summary").text().contains("− 2 missing");
  })) << Find<QLabel>("diff.summary").text().toStdString();
  KeepPictures(*window_, "flow-diff");

  ASSERT_NO_FATAL_FAILURE(ClickWhenReady("diff.restore"));
  ASSERT_TRUE(Eventually([this] { return Find<QPushButton>("plan.carryOut").isVisible(); }));
  KeepPictures(*window_, "flow-plan");
  ASSERT_NO_FATAL_FAILURE(ClickWhenReady("plan.carryOut"));
  ASSERT_TRUE(Eventually(is_restored)) << Find<QLabel>("plan.summary").text().toStdString();
  ASSERT_TRUE(Eventually([this] { return window_->files().restore().canUndo(); }));
  EXPECT_EQ(session_->activity().command(0), "gcm apply '" + File() + "'");

  ASSERT_NO_FATAL_FAILURE(ClickWhenReady("plan.undo"));
  ASSERT_NO_FATAL_FAILURE(ClickWhenReady("plan.carryOut"));
  EXPECT_TRUE(Eventually([this] {
    const Catalogue& catalogue = session_->store().catalogue();
    return catalogue.FindComponent("robot", "host_monitor") == nullptr &&
           catalogue.FindConnection({"desk", "supervisor", "Robot"}) == nullptr;
  }));
}

TEST_F(DemoFlow, UndoingTheDemoEndsItsProcesses) {
  ASSERT_NO_FATAL_FAILURE(BringUpDemo());
  ClickTab("centre.tabs", "Diff");

  Click(Find<QPushButton>("plan.undo"));
  Click(Find<QPushButton>("plan.carryOut"));

  EXPECT_TRUE(Eventually([this] { return IsEnded("robot") && IsEnded("desk"); }));
}

}  // namespace
}  // namespace tendon::gui
