#include "diagnosis/real_system.h"

#include <gcm_gui/graph/items/edge_item.h>
#include <gcm_gui/theme/theme.h>
#include <program/network_options.h>

#include <QAbstractItemView>
#include <QTest>
#include <map>
#include <utility>

#include "support/program.h"

namespace tendon::gui {
namespace {

constexpr int kLongest = 120'000;  // ms; bounds a test that fails

using Environment = std::map<std::string, std::string>;

/// Programs of one user share a run-time folder. These programs use the folder of the test.
Environment SharedWithTest() {
  return {{"XDG_RUNTIME_DIR", qEnvironmentVariable("XDG_RUNTIME_DIR").toStdString()}};
}

}  // namespace

RealSystem::RealSystem() {
  Environment own = SharedWithTest();
  own["XDG_STATE_HOME"] = home_.path().string();
  gcm_ =
      std::make_unique<Program>(Program::Words{Built("bin/gcm"), "--gcm", address_, "serve"}, own);
  EXPECT_TRUE(Eventually([this] { return gcm_->out().starts_with("GCM at "); })) << gcm_->err();
  session_ = std::make_unique<GcmSession>(*program::MakeMiddleware({}), address_, false,
                                          Role::kOperator, std::chrono::seconds(20));
  window_ = std::make_unique<MainWindow>(PartsOf(*session_));
  window_->show();
  window_->activateWindow();
  (void)QTest::qWaitForWindowActive(window_.get(), kLongest);
  EXPECT_TRUE(
      Eventually([this] { return session_->link().state() == LinkState::State::kConnected; }));
}

RealSystem::~RealSystem() { Theme::instance().choose(Theme::Choice::kSystem); }

void RealSystem::StartLcm(const std::string& process) {
  lcms_[process] = std::make_unique<Program>(
      Program::Words{Built("bin/lcm"), "--name", process, "--gcm", address_, "--timeout", "20000",
                     "--system", TENDON_DEMO_SYSTEM},
      SharedWithTest());
  const std::string last = process == "robot" ? "host_monitor" : "old_arm";
  ASSERT_TRUE(Eventually([&] {
    const auto* component = Known().FindComponent(process, last);
    return component != nullptr && component->state == ComponentState::kActive;
  })) << lcm(process).err();
}

Outcome RealSystem::Gcm(Program::Words words) const {
  words.insert(words.begin(), {Built("bin/gcm"), "--gcm", address_, "--timeout", "20000"});
  return RunProgram(words, SharedWithTest());
}

bool RealSystem::IsConnected(const InterfaceName& required) {
  const auto* connection = Known().FindConnection(required);
  return connection != nullptr && connection->state == ConnectionState::kActive;
}

ProcessState RealSystem::StateOf(const std::string& process) {
  return Known().FindProcess(process)->process.state;
}

bool RealSystem::Eventually(const std::function<bool()>& holds) {
  return QTest::qWaitFor(holds, kLongest);
}

void RealSystem::ClickPort(const PortName& port) {
  ASSERT_TRUE(Eventually([&] { return window_->graph().pointOf(port).has_value(); }));
  QTest::mouseClick(window_->graph().viewport(), Qt::LeftButton, {},
                    *window_->graph().pointOf(port));
}

void RealSystem::ClickEdge(const QString& required) {
  GraphView& graph = window_->graph();
  ASSERT_TRUE(Eventually([&] { return graph.graph().edge(required) != nullptr; }));
  // Searches a point of the edge that no other item covers.
  const EdgeItem* edge = graph.graph().edge(required);
  for (int percent = 20; percent < 80; ++percent) {
    const QPoint point = graph.mapFromScene(edge->path().pointAtPercent(percent / 100.0));
    if (graph.itemAt(point) != edge) continue;
    return QTest::mouseClick(graph.viewport(), Qt::LeftButton, {}, point);
  }
  FAIL() << "all of the edge of " << required.toStdString() << " is covered";
}

void RealSystem::ClickRow(const QString& list, const QString& text) {
  auto* view = window_->findChild<QAbstractItemView*>(list);
  ASSERT_NE(view, nullptr);
  QModelIndexList found;
  ASSERT_TRUE(Eventually([&] {
    found = view->model()->match(view->model()->index(0, 0), Qt::DisplayRole, text, 1,
                                 Qt::MatchContains);
    return !found.isEmpty();
  })) << text.toStdString();
  view->scrollTo(found.front());
  QTest::mouseClick(view->viewport(), Qt::LeftButton, {},
                    view->visualRect(found.front()).topLeft() + QPoint(40, 8));
}

}  // namespace tendon::gui
