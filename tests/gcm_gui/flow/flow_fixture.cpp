#include "flow/flow_fixture.h"

#include <gcm_gui/theme/theme.h>
#include <program/network_options.h>

#include <QTabBar>
#include <utility>

#include "support/program.h"
#include "support/wait.h"

namespace tendon::gui {
namespace {

constexpr const char* kTimeout = "20000";  // ms

}  // namespace

std::map<std::string, std::string> FlowFixture::FlowEnvironment() const {
  return {{"XDG_RUNTIME_DIR", qEnvironmentVariable("XDG_RUNTIME_DIR").toStdString()},
          {"XDG_STATE_HOME", home_.path().string()}};
}

std::unique_ptr<Program> FlowFixture::StartLcm(const std::string& name,
                                               const std::string& system) const {
  return std::make_unique<Program>(
      Program::Words{Built("bin/lcm"), "--name", name, "--gcm", address_, "--timeout", kTimeout,
                     "--system", system},
      FlowEnvironment());
}

std::unique_ptr<Program> FlowFixture::StartGcmVerb(const Program::Words& words) const {
  Program::Words all{Built("bin/gcm"), "--gcm", address_};
  all.insert(all.end(), words.begin(), words.end());
  return std::make_unique<Program>(all, FlowEnvironment());
}

void FlowFixture::StartGcm() {
  gcm_ = std::make_unique<Program>(Program::Words{Built("bin/gcm"), "--gcm", address_, "serve"},
                                   FlowEnvironment());
  ASSERT_TRUE(EventuallyTrue([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
}

void FlowFixture::OpenWindow() {
  const program::NetworkOptions network;
  session_ = std::make_unique<GcmSession>(*program::MakeMiddleware(network), address_, false,
                                          Role::kOperator, std::chrono::seconds(20));
  WindowParts parts = PartsOf(*session_);
  parts.console.gcm = address_;
  parts.console.network = network;
  parts.console.timeout = std::chrono::seconds(20);
  parts.console.color = console::ColorChoice::kNever;
  parts.gcm = {QString::fromStdString(Built("bin/gcm"))};
  parts.demo = QString::fromStdString(Built("share/tendon/systems/demo.json"));
  window_ = std::make_unique<MainWindow>(parts);
  window_->show();
  window_->activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(window_.get(), kFlowTimeout));
}

void FlowFixture::SetUp() {
  ASSERT_NO_FATAL_FAILURE(StartGcm());
  robot_ = StartLcm("robot");
  desk_ = StartLcm("desk");
  ASSERT_NO_FATAL_FAILURE(OpenWindow());
  ASSERT_TRUE(Eventually([this] { return IsDemoRunning(); })) << robot_->err() << desk_->err();
}

bool FlowFixture::IsDemoRunning() const {
  const Catalogue& catalogue = session_->store().catalogue();
  const auto is_active = [&](const char* process, const char* component) {
    const auto* found = catalogue.FindComponent(process, component);
    return found != nullptr && found->state == ComponentState::kActive;
  };
  return is_active("robot", "arm") && is_active("robot", "host_monitor") &&
         is_active("desk", "teleoperation") && is_active("desk", "supervisor") &&
         is_active("desk", "old_arm") &&
         catalogue.FindConnection({"desk", "supervisor", "Robot"}) != nullptr;
}

void FlowFixture::TearDown() {
  Theme::instance().choose(Theme::Choice::kSystem);
  window_.reset();
  session_.reset();
}

void FlowFixture::ClickTab(const char* bar, const char* title) {
  auto& tabs = Find<QTabBar>(bar);
  for (int tab = 0; tab < tabs.count(); ++tab) {
    if (!tabs.tabText(tab).startsWith(QString::fromLatin1(title))) continue;
    return QTest::mouseClick(&tabs, Qt::LeftButton, {}, tabs.tabRect(tab).center());
  }
  ADD_FAILURE() << "no tab " << title;
}

void FlowFixture::MoveArm() {
  session_->callCommand("robot/arm/Control.MoveTo",
                        R"({"position": [0.1, 0, 0, -1.5, 0, 1.5, 0], "duration": 0.05})",
                        [](const auto&, double) {});
  QTest::qWait(200);
}

void FlowFixture::Click(QWidget& widget) { QTest::mouseClick(&widget, Qt::LeftButton); }

}  // namespace tendon::gui
