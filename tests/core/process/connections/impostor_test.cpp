#include "support/peers/impostor.h"

#include <gmock/gmock.h>

#include "core/process/connections/remote_connection.h"

namespace {

using testing::AllOf;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using AdvertisedElsewhere = RemoteConnection;

TEST_P(AdvertisedElsewhere, ThePeerThereReceivesOnlyAHello) {
  const tendon::test::Impostor third(NewMiddleware(), "robot");
  tendon::ProcessOptions options = Options();
  options.advertise = third.address();
  robot = std::make_unique<tendon::Process>("robot", options);
  ASSERT_TRUE(robot->WaitUntilJoined(std::chrono::seconds(20)).ok());
  plant = &robot->Add<plant::Plant>("plant");
  ASSERT_TRUE(robot->StartAll().ok());
  StartDesk();

  (void)desk->Connect(kRobot, kControl);

  EXPECT_TRUE(EventuallyTrue([&] { return third.links() > 0; }));
  EXPECT_TRUE(EventuallyPending(*desk));
  EXPECT_THAT(Reason(), HasSubstr("robot does not know 'desk'"));
  desk.reset();
  EXPECT_THAT(third.heard(), AllOf(Not(IsEmpty()), Each(tendon::MessageType::kHello)));
}

INSTANTIATE_TEST_SUITE_P(Over, AdvertisedElsewhere, testing::ValuesIn(NetworkKinds()),
                         NameOfNetwork);

}  // namespace
