#include <gcm_gui/diagnosis/refused_connections.h>
#include <gtest/gtest.h>

#include <QSignalSpy>

#include "support/sample_system.h"

namespace tendon::gui {
namespace {

const InterfaceName kRequired{"desk", "view", "Host"};
const InterfaceName kProvided{"desk", "host_monitor", "state"};

class RefusedConnectionsTest : public ::testing::Test {
 protected:
  void Finish(Action::Verb verb, Action::Outcome outcome) {
    Action action;
    action.verb = verb;
    action.required = kRequired;
    action.provided = verb == Action::Verb::kDisconnect ? InterfaceName{} : kProvided;
    action.outcome = outcome;
    action.refusal = outcome == Action::Outcome::kRefused ? "no reply" : "";
    refusals_.onActionFinished(action);
  }

  RefusedConnections refusals_;
  QSignalSpy changed_{&refusals_, &RefusedConnections::changed};
};

TEST_F(RefusedConnectionsTest, KeepsARefusalUntilTheConnectionIsMade) {
  Finish(Action::Verb::kConnect, Action::Outcome::kRefused);

  ASSERT_NE(refusals_.find(kRequired), nullptr);
  EXPECT_EQ(refusals_.find(kRequired)->provided, kProvided);
  EXPECT_EQ(refusals_.find(kRequired)->reason, "no reply");

  Finish(Action::Verb::kReplace, Action::Outcome::kDone);

  EXPECT_EQ(refusals_.find(kRequired), nullptr);
  EXPECT_EQ(changed_.count(), 2);
}

TEST_F(RefusedConnectionsTest, IgnoresARefusedDisconnect) {
  Finish(Action::Verb::kDisconnect, Action::Outcome::kRefused);

  EXPECT_TRUE(refusals_.all().empty());
  EXPECT_EQ(changed_.count(), 0);
}

TEST_F(RefusedConnectionsTest, AConnectionByAnotherProgramClearsARefusal) {
  SystemBuilder system = LookSystem(0);
  Finish(Action::Verb::kConnect, Action::Outcome::kRefused);

  system.Disconnect(kRequired);
  refusals_.update(system.catalogue());
  EXPECT_NE(refusals_.find(kRequired), nullptr);

  system.Connect(kRequired, kProvided);
  refusals_.update(system.catalogue());
  EXPECT_EQ(refusals_.find(kRequired), nullptr);
}

TEST_F(RefusedConnectionsTest, ForgetsARefusalWithItsInterface) {
  SystemBuilder system = LookSystem(0);
  Finish(Action::Verb::kConnect, Action::Outcome::kRefused);

  system.RemoveComponent("desk", "view");
  refusals_.update(system.catalogue());

  EXPECT_TRUE(refusals_.all().empty());
}

}  // namespace
}  // namespace tendon::gui
