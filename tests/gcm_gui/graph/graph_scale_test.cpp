#include <gcm_gui/graph/graph_hover.h>
#include <gcm_gui/graph/graph_search.h>
#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/models/text.h>
#include <gtest/gtest.h>
#include <tendon/base/os/thread.h>

#include <QCoreApplication>
#include <QLineEdit>
#include <QString>
#include <QTest>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "graph/graph_fixture.h"
#include "support/large_system.h"

namespace tendon::gui {
namespace {

constexpr int kProcesses = 20;
constexpr int kOfEach = 50;

/// Measures the CPU time of the window's handlers for a thousand components. The times are only
/// reported, because they depend on the build.
class GraphScaleTest : public GraphFixture {
 protected:
  GraphScaleTest() : GraphFixture(LargeSystem(kProcesses, kOfEach)) { view_.resize(1000, 600); }

  void AwaitLayout() {
    constexpr int kLayoutTimeout = 60'000;  // ms
    ASSERT_TRUE(QTest::qWaitFor([this] { return !IsAnnouncing(store_) && !scene_.isArranging(); },
                                kLayoutTimeout));
  }

  template <typename Step>
  void Time(const char* what, Step step) {
    const auto before = os::ThreadCpuTime();
    step();
    const std::chrono::duration<double, std::milli> used = os::ThreadCpuTime() - before;
    std::printf("  %-44s %7.2f ms\n", what, used.count());
    RecordProperty(what, std::to_string(used.count()));
  }
};

TEST_F(GraphScaleTest, AThousandComponentsAreShownAndFollowed) {
  const InterfaceName client{LargeProcess(3), LargeComponent(7), "Arm"};
  const InterfaceName other{LargeProcess(4), LargeComponent(7), "Drives"};
  view_.show();
  Time("the first of it appears", [&] { Show(); });
  while (IsAnnouncing(store_))
    Time("more of it appears", [] { QCoreApplication::processEvents(); });
  AwaitLayout();
  EXPECT_EQ(scene_.components().size(), std::size_t{kProcesses * kOfEach});

  ComponentDescription one = *system_.catalogue().FindComponent(LargeProcess(5), LargeComponent(5));
  one.state = ComponentState::kFaulted;
  system_.Component(LargeProcess(5), one);
  Time("the state of one changes", [&] { Show(); });

  system_.Disconnect(client);
  Time("one is disconnected", [&] { Show(); });
  EXPECT_EQ(scene_.edge(QString::fromStdString(ToString(client))), nullptr);

  Time("a connection is begun", [&] { mode_.start({Side::kRequired, client}); });
  Time("the pointer is on one that fits", [&] { scene_.point(PortName{Side::kProvided, other}); });
  Time("the pointer is on one that does not fit", [&] {
    scene_.point(PortName{Side::kProvided, {LargeProcess(4), LargeComponent(7), "state"}});
  });
  Time("it is left", [&] { mode_.leave(); });

  one.name = "newcomer";
  system_.Component(LargeProcess(5), one);
  Time("a component comes", [&] { Show(); });
  AwaitLayout();
  EXPECT_NE(scene_.component(QString::fromStdString(LargeProcess(5)) + "/newcomer"), nullptr);

  system_.Process(LargeProcess(6), ProcessState::kLost, 1);
  Time("a process is lost", [&] { Show(); });
  Time("another is selected", [&] {
    selection_.select(QString::fromStdString(LargeProcess(9) + '/' + LargeComponent(9)));
  });
  Time("nothing is known any more", [&] { scene_.setOutdated(true); });
}

TEST_F(GraphScaleTest, PanningDrawsOnlyVisibleDetails) {
  view_.show();
  Show();
  AwaitLayout();
  view_.fit();
  const auto ports = scene_.ports();
  const auto are_drawn = [&] {
    const QRectF seen = view_.seen();
    return std::any_of(ports.begin(), ports.end(), [&](const auto* port) {
      return port->isVisible() && seen.contains(port->scenePos());
    });
  };
  const auto pan = [&](const char* what) {
    QTest::keyClick(&view_, Qt::Key_Right, Qt::ShiftModifier);
    view_.viewport()->repaint();
    Time(what, [&] {
      QTest::keyClick(&view_, Qt::Key_Right, Qt::ShiftModifier);
      view_.viewport()->repaint();
    });
  };

  pan("a step of panning over all of it");
  EXPECT_FALSE(are_drawn());

  view_.goTo(QString::fromStdString(LargeProcess(9) + '/' + LargeComponent(9)));
  while (view_.transform().m11() < 1) view_.zoomIn();
  pan("a step of panning at 1:1");
  EXPECT_LT(view_.items(view_.viewport()->rect()).size(), 1000);
  EXPECT_TRUE(are_drawn());

  Time("the pointer comes to one", [&] {
    scene_.hover().pointNow(QString::fromStdString(LargeProcess(9) + '/' + LargeComponent(9)));
  });
  GraphSearch search(view_);
  search.open();
  Time("a word is looked for", [&] { search.field().setText("component_1"); });
  EXPECT_FALSE(search.found().isEmpty());
  Time("one is carried", [&] {
    scene_.carry({{QString::fromStdString(LargeProcess(9) + '/' + LargeComponent(9)), {0, 0}}});
  });
}

}  // namespace
}  // namespace tendon::gui
