#include <gcm_gui/graph/layout/picture_updater.h>
#include <gtest/gtest.h>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

void ExpectSame(const GraphPicture& a, const GraphPicture& b) {
  ASSERT_EQ(a.processes.size(), b.processes.size());
  for (std::size_t i = 0; i < a.processes.size(); ++i) {
    EXPECT_EQ(a.processes[i].name, b.processes[i].name);
    EXPECT_EQ(a.processes[i].state, b.processes[i].state);
    EXPECT_EQ(a.processes[i].nodes, b.processes[i].nodes) << a.processes[i].name.toStdString();
  }
  EXPECT_EQ(a.edges, b.edges);
  EXPECT_EQ(a.affinities, b.affinities);
}

/// A picture that is updated after each change of a system.
class PictureUpdaterTest : public ::testing::Test {
 protected:
  PictureUpdaterTest() {
    QObject::connect(&store_, &CatalogueStore::changed, &store_,
                     [this](const Catalogue& catalogue, const ChangedParts& touched) {
                       updater_.update(catalogue, touched);
                     });
    Follow();
  }

  void Follow() {
    store_.apply(system_.TakeChanges());
    ExpectSame(updater_.picture(), PictureOf(system_.catalogue()));
  }

  SystemBuilder system_ = LookSystem(0);
  CatalogueStore store_;
  PictureUpdater updater_;
};

TEST_F(PictureUpdaterTest, FollowsConnections) {
  system_.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  Follow();
  system_.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"},
                  ConnectionState::kFailed, "no reply");
  Follow();
  system_.Disconnect({"desk", "teleoperation", "Robot"});
  Follow();
}

TEST_F(PictureUpdaterTest, MarksAComponentAsWaitingUntilConnected) {
  const auto waits = [this] {
    for (const auto& process : updater_.picture().processes) {
      for (const auto& node : process.nodes) {
        if (node.path == "desk/teleoperation") return NamesOf(node.waits);
      }
    }
    return std::string("no such component");
  };
  EXPECT_EQ(waits(), "Robot");

  system_.Connect({"desk", "teleoperation", "Robot"}, {"robot", "controller", "Control"});
  Follow();

  EXPECT_EQ(waits(), "");
}

TEST_F(PictureUpdaterTest, FollowsComponentsAndTheirInterfaces) {
  ComponentDescription arm = *system_.catalogue().FindComponent("robot", "arm");
  arm.state = ComponentState::kFaulted;
  system_.Component("robot", arm);
  Follow();
  arm.provided.clear();
  system_.Component("robot", arm);
  Follow();
  arm.name = "another";
  system_.Component("robot", arm);
  Follow();
  system_.RemoveComponent("robot", "arm");
  Follow();
}

TEST_F(PictureUpdaterTest, FollowsProcesses) {
  system_.Process("robot", ProcessState::kLost, 1);
  Follow();
  // The restarted process has no components yet.
  system_.Process("robot", ProcessState::kAlive, 2, 2);
  Follow();
  system_.Process("about").Component("about", Task("first", 1, {}));
  Follow();
  system_.RemoveProcess("desk");
  Follow();
}

TEST_F(PictureUpdaterTest, FollowsASnapshot) {
  SystemBuilder other;
  other.Process("robot").Component("robot", Task("only", 1, {}));

  store_.replace(other.catalogue());

  ExpectSame(updater_.picture(), PictureOf(other.catalogue()));
}

}  // namespace
}  // namespace tendon::gui
