#include <gcm_gui/graph/graph_view.h>
#include <gcm_gui/system/restore.h>
#include <gcm_gui/window/bar/notice_line.h>
#include <gcm_gui/window/file/system_files.h>
#include <gtest/gtest.h>
#include <tendon/gcm/lookup.h>

#include <QFileDialog>
#include <QLineEdit>
#include <QPushButton>

#include "flow/flow_fixture.h"
#include "support/pictures.h"

namespace tendon::gui {
namespace {

/// Nothing runs but a GCM, which starts processes beside itself.
class DemoFlow : public FlowFixture {
 protected:
  void SetUp() override {
    ASSERT_NO_FATAL_FAILURE(StartGcm());
    ASSERT_NO_FATAL_FAILURE(OpenWindow());
    ASSERT_TRUE(
        Eventually([this] { return session_->link().state() == GcmLink::State::kConnected; }));
  }
  /// What the GCM has started outlives it.
  void TearDown() override {
    for (const char* process : {"robot", "desk"}) {
      if (IsEnded(process)) continue;
      const Outcome ended = RunProgram({std::string(TENDON_BIN) + "/gcm", "--gcm", address_,
                                        "--timeout", "20000", "kill", process},
                                       FlowEnvironment());
      EXPECT_EQ(ended.exit_code, 0) << ended.err;
    }
    FlowFixture::TearDown();
  }
  [[nodiscard]] bool IsEnded(const char* process) const {
    const ProcessEntry* entry = session_->store().catalogue().FindProcess(process);
    return entry == nullptr || !IsPresent(entry->process);
  }
};

TEST_F(DemoFlow, OneClickBringsItUp) {
  Click(Find<QPushButton>("tryDemo"));

  EXPECT_TRUE(Eventually([this] { return IsDemoRunning(); })) << gcm_->err();
  EXPECT_TRUE(Eventually([this] {
    return window_->findChild<NoticeLine*>()->text().startsWith("The demo runs");
  })) << window_->findChild<NoticeLine*>()->text().toStdString();
  EXPECT_TRUE(window_->graph().isVisible());
  KeepPictures(*window_, "flow-demo");
}

TEST_F(DemoFlow, WhatIsSavedOfItStartsItsProcessesAgain) {
  Click(Find<QPushButton>("tryDemo"));
  ASSERT_TRUE(Eventually([this] { return IsDemoRunning(); })) << gcm_->err();
  ASSERT_TRUE(Eventually([this] { return window_->files().restore().canUndo(); }));
  const QString file = QString::fromStdString((home_.path() / "demo.gcm.json").string());

  QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(Eventually([this] { return window_->findChild<QFileDialog*>() != nullptr; }));
  auto* name = window_->findChild<QFileDialog*>()->findChild<QLineEdit*>("fileNameEdit");
  name->setText(file);
  QTest::keyClick(name, Qt::Key_Return);
  ASSERT_TRUE(Eventually([this] { return window_->files().document().isOpen(); }));
  ClickTab("centre.tabs", "Diff");
  KeepPictures(*window_, "flow-saved");

  const auto saved = ReadSystemFile(file.toStdString());
  ASSERT_TRUE(saved.ok());
  for (const char* process : {"robot", "desk"}) {
    ASSERT_NE(saved->FindProcess(process), nullptr) << process;
    EXPECT_TRUE(saved->FindProcess(process)->start.has_value()) << process;
  }
}

TEST_F(DemoFlow, TakenBackItLeavesNoProcess) {
  Click(Find<QPushButton>("tryDemo"));
  ASSERT_TRUE(Eventually([this] { return IsDemoRunning(); })) << gcm_->err();
  ASSERT_TRUE(Eventually([this] { return window_->files().restore().canUndo(); }));
  ClickTab("centre.tabs", "Diff");

  Click(Find<QPushButton>("plan.undo"));
  Click(Find<QPushButton>("plan.carryOut"));

  EXPECT_TRUE(Eventually([this] { return IsEnded("robot") && IsEnded("desk"); }));
}

}  // namespace
}  // namespace tendon::gui
