#include <gcm_gui/graph/layout/graph_layout.h>
#include <gcm_gui/graph/layout/picture_updater.h>
#include <gtest/gtest.h>

#include <map>
#include <random>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

std::map<QString, QRectF> Places(const GraphLayout& layout, const GraphPicture& picture) {
  std::map<QString, QRectF> places;
  for (const auto& process : picture.processes) {
    places[process.name] = layout.process(process.name);
    for (const auto& node : process.nodes) places[node.path] = layout.node(node.path);
  }
  return places;
}

void ExpectNothingOverlaps(const GraphLayout& layout, const GraphPicture& picture) {
  const auto apart = [](const QRectF& a, const QRectF& b) { return !a.intersects(b); };
  for (const auto& a : picture.processes) {
    for (const auto& b : picture.processes) {
      if (&a == &b) continue;
      EXPECT_TRUE(apart(layout.process(a.name), layout.process(b.name)))
          << a.name.toStdString() << " and " << b.name.toStdString();
    }
    for (const auto& node : a.nodes) {
      EXPECT_TRUE(layout.process(a.name).contains(layout.node(node.path)));
      for (const auto& other : a.nodes) {
        if (&node == &other) continue;
        EXPECT_TRUE(apart(layout.node(node.path), layout.node(other.path)))
            << node.path.toStdString() << " and " << other.path.toStdString();
      }
    }
  }
}

class GraphLayoutTest : public ::testing::Test {
 protected:
  GraphPicture Show(const SystemBuilder& system) {
    GraphPicture picture = PictureOf(system.catalogue());
    layout_.update(picture);
    return picture;
  }

  GraphLayout layout_;
};

TEST_F(GraphLayoutTest, PlacesProvidersLeftOfTheirClients) {
  Show(LookSystem(0));

  EXPECT_LT(layout_.node("robot/arm").right(), layout_.node("robot/controller").left());
  EXPECT_LT(layout_.node("desk/host_monitor").right(), layout_.node("desk/view").left());
  // A possible connection determines the position, so making the connection does not move the
  // component.
  EXPECT_LT(layout_.process("robot").right(), layout_.process("desk").left());
}

TEST_F(GraphLayoutTest, NodesDoNotOverlapAndLieInTheirProcess) {
  const GraphPicture picture = Show(LookSystem(0));
  ExpectNothingOverlaps(layout_, picture);
}

TEST_F(GraphLayoutTest, ConnectingMovesNoNode) {
  SystemBuilder system = LookSystem(0);
  const auto before = Places(layout_, Show(system));

  system.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  system.Disconnect({"desk", "view", "Host"});
  const auto after = Places(layout_, Show(system));

  EXPECT_EQ(before, after);
}

TEST_F(GraphLayoutTest, ALostProcessKeepsItsPlace) {
  SystemBuilder system = LookSystem(0);
  const auto before = Places(layout_, Show(system));
  const ComponentDescription camera = *system.catalogue().FindComponent("vision", "camera");

  system.Process("robot", ProcessState::kLost, 1);
  EXPECT_EQ(Places(layout_, Show(system)), before);

  system.Process("vision", ProcessState::kAlive, 0, 2);  // the process has no components at first
  Show(system);
  system.Component("vision", camera);
  EXPECT_EQ(Places(layout_, Show(system)).at("vision/camera").topLeft(),
            before.at("vision/camera").topLeft());
}

TEST_F(GraphLayoutTest, RejoiningAfterAGcmRestartKeepsAllPlaces) {
  SystemBuilder system = LookSystem(0);
  system.Process("vision");
  const auto before = Places(layout_, Show(system));
  SystemBuilder again;
  for (const auto& [name, entry] : system.catalogue().processes()) {
    again.Process(name);
    Show(again);
    for (const auto& [component, description] : entry.components) {
      again.Component(name, description);
      Show(again);
    }
  }

  const auto after = Places(layout_, Show(again));

  for (const auto& [path, rect] : before) {
    EXPECT_EQ(after.at(path), rect) << path.toStdString();
  }
}

TEST_F(GraphLayoutTest, ANewComponentMovesNoOther) {
  SystemBuilder system = LookSystem(0);
  const auto before = Places(layout_, Show(system));

  system.Component("robot", Task("logger", 0.1, {Column("Log", "t.Log")}));
  const GraphPicture picture = Show(system);

  for (const auto& path : {"robot/arm", "robot/force_sensor", "robot/controller"}) {
    EXPECT_EQ(layout_.node(path).topLeft(), before.at(path).topLeft()) << path;
  }
  ExpectNothingOverlaps(layout_, picture);
}

TEST_F(GraphLayoutTest, PlacesEmptyProcessesLast) {
  SystemBuilder system;
  system.Process("gcm");
  Show(system);

  system.Process("robot").Component("robot", Task("arm", 1e-3, {}));
  Show(system);

  EXPECT_LT(layout_.process("robot").top(), layout_.process("gcm").top());
}

TEST_F(GraphLayoutTest, RandomSystemsNeverOverlap) {
  SystemBuilder system;
  std::mt19937 random(7);
  const auto pick = [&](int count) {
    return static_cast<int>(random() % static_cast<unsigned>(count));
  };
  for (int step = 0; step < 120; ++step) {
    const std::string process = "p" + std::to_string(pick(4));
    const std::string name = "c" + std::to_string(pick(12));
    if (system.catalogue().FindProcess(process) == nullptr) system.Process(process);
    if (pick(4) == 0) {
      system.RemoveComponent(process, name);
    } else {
      ComponentDescription task = Task(name, 1e-3, {Column("X" + std::to_string(pick(3)), "t")});
      for (int i = pick(3); i > 0; --i) {
        task.required.push_back(
            {"R" + std::to_string(i), {Read("X" + std::to_string(pick(3)), "t")}, {}, false});
      }
      system.Component(process, task);
    }
    const GraphPicture picture = Show(system);
    if (step % 10 == 0) ExpectNothingOverlaps(layout_, picture);
  }
}

TEST_F(GraphLayoutTest, ManyUnconnectedComponentsFormABox) {
  SystemBuilder system;
  system.Process("p");
  for (int i = 0; i < 60; ++i) system.Component("p", Task("c" + std::to_string(i), 1e-3, {}));

  Show(system);

  const QRectF box = layout_.process("p");
  EXPECT_LT(box.height(), 3 * box.width());
}

}  // namespace
}  // namespace tendon::gui
