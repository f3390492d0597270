#include <gcm_gui/session/gcm_session.h>
#include <gcm_gui/system/diff_panel.h>
#include <gcm_gui/system/system_files.h>
#include <gcm_gui/theme/theme.h>
#include <gcm_gui/window/main_window.h>
#include <gtest/gtest.h>
#include <support/plant.h>
#include <tendon/gcm/global_manager.h>
#include <tendon/middleware/loopback.h>
#include <tendon/process/process.h>

#include <QAction>
#include <QFile>
#include <QFileDialog>
#include <QInputDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <functional>

#include "support/pictures.h"

namespace tendon::gui {
namespace {

constexpr int kFlowTimeout = 120'000;  // ms; bounds a test that fails

const InterfaceName kFlowRequired{"desk", "operator", "Robot"};
const InterfaceName kFlowProvided{"robot", "plant", "Control"};

/// A whole window, a GCM, and two processes with real components.
class SystemFlowTest : public ::testing::Test {
 protected:
  SystemFlowTest() {
    manager_ = std::move(*GlobalManager::Start(
        Node(), {.address = "127.0.0.1:0", .state_folder = folder_.path().toStdString()}));
    const ProcessOptions options{.middleware = Node(), .gcm = manager_->address()};
    robot_ = std::make_unique<Process>("robot", options);
    robot_->Add<plant::Plant>("plant");
    (void)robot_->StartAll();
    desk_ = std::make_unique<Process>("desk", options);
    desk_->Add<plant::Operator>("operator");
    (void)desk_->StartAll();
    Open({}, Role::kOperator);
  }
  ~SystemFlowTest() override { Theme::instance().choose(Theme::Choice::kSystem); }

  void Open(const QString& read_only, Role role) {
    window_.reset();
    session_ = std::make_unique<GcmSession>(Node(), manager_->address(), true, role,
                                            std::chrono::seconds(20));
    WindowParts parts = PartsOf(*session_);
    parts.read_only = read_only;
    window_ = std::make_unique<MainWindow>(parts);
    window_->show();
    window_->activateWindow();
    (void)QTest::qWaitForWindowActive(window_.get(), kFlowTimeout);
  }

  std::shared_ptr<Middleware> Node() { return std::make_shared<LoopbackMiddleware>(network_); }
  bool Eventually(const std::function<bool()>& holds) {
    return QTest::qWaitFor(holds, kFlowTimeout);
  }
  bool IsConnected() {
    const auto* connection = session_->store().catalogue().FindConnection(kFlowRequired);
    return connection != nullptr && connection->state == ConnectionState::kActive;
  }
  bool EverythingIsThere() {
    return Eventually([&] {
      const Catalogue& catalogue = session_->store().catalogue();
      const auto is_active = [&](const char* process, const char* component) {
        const auto* found = catalogue.FindComponent(process, component);
        return found != nullptr && found->state == ComponentState::kActive;
      };
      return is_active("robot", "plant") && is_active("desk", "operator");
    });
  }
  bool Connect() {
    session_->connectInterfaces(kFlowRequired, kFlowProvided);
    return Eventually([&] { return IsConnected(); });
  }

  QString File() { return folder_.filePath("plant.gcm.json"); }
  SystemDocument& Document() { return window_->files().document(); }
  [[nodiscard]] QString Words(const char* label) const {
    return window_->findChild<QLabel*>(label)->text();
  }
  [[nodiscard]] QPushButton& Button(const char* name) const {
    return *window_->findChild<QPushButton*>(name);
  }
  void Click(const char* name) {
    ASSERT_TRUE(Eventually([&] { return Button(name).isVisible() && Button(name).isEnabled(); }))
        << name;
    QTest::mouseClick(&Button(name), Qt::LeftButton);
  }

  /// Presses Ctrl+S, and types the name of the file in the dialog.
  void SaveByKeys() {
    QTest::keyClick(window_.get(), Qt::Key_S, Qt::ControlModifier);
    ASSERT_TRUE(Eventually([&] { return window_->findChild<QFileDialog*>() != nullptr; }));
    auto* dialog = window_->findChild<QFileDialog*>();
    auto* name = dialog->findChild<QLineEdit*>("fileNameEdit");
    ASSERT_NE(name, nullptr);
    name->setText(File());
    QTest::keyClick(name, Qt::Key_Return);
    ASSERT_TRUE(Eventually([&] { return Document().isOpen(); }));
  }

  QTemporaryDir folder_;
  std::shared_ptr<LoopbackNetwork> network_ = std::make_shared<LoopbackNetwork>();
  std::unique_ptr<GlobalManager> manager_;
  std::unique_ptr<Process> robot_;
  std::unique_ptr<Process> desk_;
  std::unique_ptr<GcmSession> session_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(SystemFlowTest, ImportsACisstFileAndSavesTheRunningSystem) {
  ASSERT_TRUE(EverythingIsThere());
  const QString cisst = folder_.filePath("lab.json");
  QFile file(cisst);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write(R"({"connections": [{"required": {"component": "plant", "interface": "Arm"},
                                  "provided": {"component": "MTML", "interface": "Arm"}}]})");
  file.close();
  QAction* importing = window_->findChild<QAction*>("Import a cisst file");
  ASSERT_NE(importing, nullptr);
  importing->trigger();
  auto* files = window_->findChild<QFileDialog*>();
  ASSERT_NE(files, nullptr);
  files->findChild<QLineEdit*>("fileNameEdit")->setText(cisst);
  QTest::keyClick(files->findChild<QLineEdit*>("fileNameEdit"), Qt::Key_Return);
  ASSERT_TRUE(
      Eventually([&] { return window_->findChild<QInputDialog*>("importProcess") != nullptr; }));
  auto* process = window_->findChild<QInputDialog*>("importProcess");
  process->setTextValue("robot");
  QTest::keyClick(process, Qt::Key_Return);

  ASSERT_TRUE(Eventually([&] { return Document().isOpen(); }));
  EXPECT_EQ(Document().path(), folder_.filePath("lab.gcm.json"));
  EXPECT_NE(Document().file().FindComponent("robot", "MTML"), nullptr);
  const std::string made = Document().path().toStdString();
  EXPECT_NE(ReadSystemFile(made)->FindComponent("robot", "MTML"), nullptr);

  QSignalSpy told(&Document(), &SystemDocument::notice);
  window_->findChild<QAction*>("Save the running system")->trigger();
  ASSERT_TRUE(Eventually([&] { return told.count() == 1; }));
  const auto saved = ReadSystemFile(made);
  EXPECT_NE(saved->FindComponent("robot", "MTML"), nullptr) << "it does not run yet";
  EXPECT_NE(saved->FindComponent("desk", "operator"), nullptr);
  EXPECT_EQ(saved->connections.size(), 1U);
}

TEST_F(SystemFlowTest, AnImportOverwritesNoFile) {
  const auto write = [&](const QString& name, const QByteArray& text) {
    QFile file(folder_.filePath(name));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
  };
  write("lab.json", R"({"components": []})");
  write("lab.gcm.json", "mine");
  QSignalSpy told(&Document(), &SystemDocument::notice);

  Document().importFrom(folder_.filePath("lab.json"), "robot");

  ASSERT_TRUE(Eventually([&] { return told.count() == 1; }));
  EXPECT_TRUE(told[0][0].toString().startsWith("lab.gcm.json already exists"))
      << told[0][0].toString().toStdString();
  EXPECT_FALSE(Document().isOpen());
  QFile kept(folder_.filePath("lab.gcm.json"));
  ASSERT_TRUE(kept.open(QIODevice::ReadOnly));
  EXPECT_EQ(kept.readAll(), "mine");
}

TEST_F(SystemFlowTest, RestoresASavedSystemAndUndoesIt) {
  ASSERT_TRUE(EverythingIsThere());
  ASSERT_TRUE(Connect());
  SaveByKeys();
  EXPECT_TRUE(window_->windowTitle().startsWith("plant.gcm.json – "));
  EXPECT_EQ(ReadSystemFile(File().toStdString())->connections.size(), 1U);

  session_->disconnectInterface(kFlowRequired);
  ASSERT_TRUE(Eventually([&] { return window_->windowTitle().contains("modified since"); }));
  EXPECT_TRUE(Words("diff.summary").contains("− 1 missing"));
  window_->findChild<QAction*>("Restore the system file")->trigger();
  ASSERT_TRUE(Eventually([&] { return Button("plan.carryOut").isVisible(); }));
  EXPECT_FALSE(IsConnected());
  KeepPictures(*window_, "system-plan");

  QTest::keyClick(&Button("plan.carryOut"), Qt::Key_Space);
  ASSERT_TRUE(Eventually([&] { return IsConnected(); }));
  Click("plan.undo");
  ASSERT_TRUE(Eventually([&] { return Button("plan.carryOut").isVisible(); }));
  Click("plan.back");  // after only a preview, the undo is still available
  EXPECT_TRUE(Words("plan.summary").contains("1 done"));
  EXPECT_TRUE(IsConnected());
  Click("plan.undo");
  Click("plan.carryOut");
  EXPECT_TRUE(Eventually([&] { return !IsConnected(); }));
}

TEST_F(SystemFlowTest, AppliesOneDifferenceOrSavesItToTheFile) {
  ASSERT_TRUE(EverythingIsThere());
  ASSERT_TRUE(Connect());
  SaveByKeys();
  session_->disconnectInterface(kFlowRequired);
  ASSERT_TRUE(Eventually([&] { return Document().comparison().differences.size() == 1; }));
  window_->findChild<QAction*>("Restore the system file")->trigger();
  Click("plan.back");
  KeepPictures(*window_, "system-diff");

  Click("diff.apply");
  Click("plan.carryOut");
  ASSERT_TRUE(Eventually([&] { return IsConnected(); }));
  Click("plan.back");
  session_->disconnectInterface(kFlowRequired);
  ASSERT_TRUE(Eventually(
      [&] { return !IsConnected() && Document().comparison().differences.size() == 1; }));
  Click("diff.update");

  ASSERT_TRUE(Eventually([&] { return Document().comparison().differences.empty(); }));
  EXPECT_TRUE(ReadSystemFile(File().toStdString())->connections.empty());
  EXPECT_FALSE(IsConnected());
}

TEST_F(SystemFlowTest, OpeningAFileShowsItsPlanAndWaits) {
  ASSERT_TRUE(EverythingIsThere());
  ASSERT_TRUE(Connect());
  SaveByKeys();
  session_->disconnectInterface(kFlowRequired);
  ASSERT_TRUE(Eventually([&] { return !IsConnected(); }));
  Open({}, Role::kOperator);
  ASSERT_TRUE(EverythingIsThere());

  window_->files().bringUp(File());

  ASSERT_TRUE(Eventually([&] { return window_->files().restore().plan().steps.size() == 1; }));
  EXPECT_FALSE(IsConnected());
  Click("plan.carryOut");
  EXPECT_TRUE(Eventually([&] { return IsConnected(); }));
}

TEST_F(SystemFlowTest, AViewersWindowExplainsThatItIsReadOnly) {
  ASSERT_TRUE(EverythingIsThere());
  ASSERT_TRUE(Connect());
  SaveByKeys();
  session_->disconnectInterface(kFlowRequired);
  ASSERT_TRUE(Eventually([&] { return !IsConnected(); }));
  const QString reason = "this window cannot change anything";
  Open(reason, Role::kViewer);
  ASSERT_TRUE(EverythingIsThere());

  window_->files().bringUp(File());

  ASSERT_TRUE(Eventually([&] { return window_->files().restore().plan().steps.size() == 1; }));
  EXPECT_FALSE(Button("plan.carryOut").isEnabled());
  EXPECT_EQ(Button("plan.carryOut").toolTip(), reason);
  const auto* connect = window_->findChild<QAction*>("Connect");
  EXPECT_FALSE(connect->isEnabled());
  EXPECT_EQ(connect->toolTip(), reason);
  session_->connectInterfaces(kFlowRequired, kFlowProvided);
  EXPECT_TRUE(Eventually(
      [&] { return session_->activity().action(0).outcome == Action::Outcome::kRefused; }));
}

TEST_F(SystemFlowTest, TheMenuListsEarlierStates) {
  ASSERT_TRUE(EverythingIsThere());
  ASSERT_TRUE(Connect());
  const auto& states = Document().snapshots().all();
  ASSERT_TRUE(
      Eventually([&] { return !states.empty() && states.back().system.connections.size() == 1; }));
  session_->disconnectInterface(kFlowRequired);
  ASSERT_TRUE(Eventually([&] { return states.back().system.connections.empty(); }));

  auto* menu = window_->findChild<QMenu*>("states");
  Q_EMIT menu->aboutToShow();
  ASSERT_GE(menu->actions().size(), 2);
  menu->actions().at(1)->trigger();
  Click("plan.carryOut");

  EXPECT_TRUE(Eventually([&] { return IsConnected(); }));
}

}  // namespace
}  // namespace tendon::gui
