#include <gcm_gui/graph/items/component_item.h>
#include <gcm_gui/models/text.h>
#include <gtest/gtest.h>
#include <tendon/base/os/thread.h>

#include <QString>
#include <chrono>
#include <cstdio>
#include <string>

#include "graph/graph_fixture.h"

namespace tendon::gui {
namespace {

constexpr int kProcesses = 20;
constexpr int kOfEach = 50;

std::string ProcessName(int i) { return "process_" + std::to_string(100 + i); }
std::string ComponentName(int i) { return "component_" + std::to_string(100 + i); }

/// A thousand components, of which nearly all drive the one before.
SystemBuilder LargeSystem() {
  const SystemBuilder look = LookSystem(0);
  ComponentDescription model = *look.catalog().FindComponent("robot", "controller");
  model.required.resize(1);  // what the arm offers
  model.provided.push_back(look.catalog().FindComponent("robot", "arm")->provided.front());
  SystemBuilder system;
  for (int p = 0; p < kProcesses; ++p) {
    system.Process(ProcessName(p));
    for (int c = 0; c < kOfEach; ++c) {
      model.name = ComponentName(c);
      system.Component(ProcessName(p), model);
      if (c == 0) continue;
      system.Connect({ProcessName(p), ComponentName(c), "Arm"},
                     {ProcessName(p), ComponentName(c - 1), "Drives"});
    }
  }
  return system;
}

/// What handlers of the window would use for a thousand components, in CPU time of this thread;
/// reported, as it depends on the build.
class GraphScaleTest : public GraphFixture {
 protected:
  GraphScaleTest() : GraphFixture(LargeSystem()) { view_.resize(1000, 600); }

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
  const InterfaceName client{ProcessName(3), ComponentName(7), "Arm"};
  const InterfaceName other{ProcessName(4), ComponentName(7), "Drives"};
  view_.show();
  Time("all of it appears", [&] { Show(); });
  EXPECT_EQ(scene_.components().size(), std::size_t{kProcesses * kOfEach});

  ComponentDescription one = *system_.catalog().FindComponent(ProcessName(5), ComponentName(5));
  one.state = ComponentState::kFaulted;
  system_.Component(ProcessName(5), one);
  Time("the state of one changes", [&] { Show(); });

  system_.Disconnect(client);
  Time("one is disconnected", [&] { Show(); });
  EXPECT_EQ(scene_.edge(QString::fromStdString(ToString(client))), nullptr);

  Time("a connection is begun", [&] { mode_.start({Side::kRequired, client}); });
  Time("the pointer is on one that fits", [&] { scene_.point(PortName{Side::kProvided, other}); });
  Time("the pointer is on one that does not fit", [&] {
    scene_.point(PortName{Side::kProvided, {ProcessName(4), ComponentName(7), "state"}});
  });
  EXPECT_EQ(scene_.cards().size(), 1u);
  Time("it is left", [&] { mode_.leave(); });

  one.name = "newcomer";
  system_.Component(ProcessName(5), one);
  Time("a component comes", [&] { Show(); });
  EXPECT_NE(scene_.component(QString::fromStdString(ProcessName(5)) + "/newcomer"), nullptr);

  system_.Process(ProcessName(6), ProcessState::kLost, 1);
  Time("a process is lost", [&] { Show(); });
  Time("another is selected",
       [&] { selection_.select(QString::fromStdString(ProcessName(9) + '/' + ComponentName(9))); });
  Time("nothing is known any more", [&] { scene_.setOutdated(true); });
}

}  // namespace
}  // namespace tendon::gui
